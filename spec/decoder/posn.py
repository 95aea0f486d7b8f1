"""POSN: predictive geometry: the order of vertices, replacements: posn.md."""
import math
import struct
from collections import deque

import numpy as np

from coder import Coder, NumberModel
from container import LATTICE, VOXELS, must
from floats import FLT_1_bits, FLT_1_ordinal, FLT_2_last_place, FloatCoder
from graph import corners, others
from lattice import POSN_3_known, POSN_8_table, PredictedCoder, fresh_models
from voxels import VOX_1_rows

def POSN_1_positions(chunk, header, faces, states, dump):
    """The positions of the geometric vertices in doubles."""
    n = header.geometric
    if n == 0:
        must(not chunk.data, "POSN-1", "a payload without vertices")
        return np.zeros((0, 3))
    must(chunk.is_compact, "POSN-1", "the payload is not compact")
    coder = Coder(chunk.data)
    order = POSN_10_order(coder.raw(2), faces, n)
    number = {v: i for i, v in enumerate(order)}
    ordered = [tuple(number[v] for v in face) for face in faces]
    dump("order", order)
    if header.coder == VOXELS:
        positions = POSN_2_positions(VOX_1_rows(coder, ordered, n, header, states), header)
    elif header.coder == LATTICE:
        positions = POSN_9_lattice(coder, ordered, n, header, states)
    else:
        positions = FLT_positions(coder, ordered, n, header)
    coder.end()
    dump("positions in this order", positions)
    return positions[[number[v] for v in range(n)]]

def POSN_2_positions(rows, header):
    return np.array([[header.POSN_2_place(a, q) for a, q in enumerate(row)] for row in rows])

def POSN_9_lattice(coder, faces, n, header, states):
    """[POSN-9, POSN-11, POSN-13]"""
    table, guesses, replaces = POSN_8_table(coder), coder.raw(1), coder.raw(1)
    known = POSN_3_known(faces, n)
    lattice = PredictedCoder(coder, known, table, header.cells, guesses, states.models("lattice", **fresh_models()))
    v = 0
    while v < n:
        pair = v + 1 < n and known[v + 1].faces and all(v not in face[:2] for face in known[v + 1].faces)
        turns = [lattice.vertex(u) for u in ([v, v + 1] if pair else [v])]
        for _ in range(3):
            for turn in turns:
                next(turn)
        v += len(turns)
    positions = POSN_2_positions([lattice.rows[v] for v in range(n)], header)
    if replaces:
        POSN_11_replace(coder, positions)
    return positions

def POSN_11_replace(coder, positions):
    count = NumberModel().decode(coder)
    must(count <= positions.size, "POSN-11", f"{count} replacements")
    gaps, at, flat = NumberModel(), -1, positions.reshape(-1)
    for _ in range(count):
        at += 1 + gaps.decode(coder)
        value = struct.unpack("<f", struct.pack("<I", coder.raw(32)))[0]
        must(at < flat.size and math.isfinite(value), "POSN-11", "a replacement is out of range or not finite")
        flat[at] = value

def POSN_10_order(order, faces, n):
    """The vertices in the order in which they are coded."""
    must(order != 3, "POSN-10", "order 3")
    if order == 0:
        return list(range(n))
    at, placed, count, result, lists = corners(faces, n), [False] * n, [0] * n, [], [deque() for _ in range(4)]

    def place(v):
        placed[v] = True
        result.append(v)
        for a, b in (others(faces, corner) for corner in at[v]):
            u = b if placed[a] else a
            if placed[a] != placed[b] and count[u] < 3:
                count[u] += 1
                lists[count[u]].append(u)

    for first in range(n):
        if not placed[first]:
            place(first)
        while waiting := lists[3] or lists[2] or lists[1]:
            u = waiting.popleft() if order == 1 else waiting.pop()
            if not placed[u]:
                place(u)
    return result

def FLT_positions(coder, faces, n, header):
    """[FLT-2] for the units"""
    def ordinal(x):
        return FLT_1_ordinal(struct.unpack("<I", struct.pack("<f", x))[0])
    table = POSN_8_table(coder)
    units = [FLT_2_last_place(ordinal(max(abs(a), abs(b)))) - 3 for a, b in zip(header.box_min, header.box_max)]
    floats = FloatCoder(coder, POSN_3_known(faces, n), table, units)
    patterns = []
    for v in range(n):
        list(floats.vertex(v))
        patterns.append([FLT_1_bits(x) for x in floats.ordinals[v]])
    return np.array(patterns, dtype="<u4").view("<f4").astype(np.float64)
