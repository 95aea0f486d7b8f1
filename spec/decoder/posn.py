"""POSN: predictive geometry: the order of vertices, replacements: posn.md."""
from collections import deque
from logging import debug

import numpy as np

from coder import Coder, NumberModel
from container import LATTICE, must
from floats import FLT_1_bits, FLT_2_last_place, FloatCoder
from graph import corners
from lattice import POSN_2_positions, POSN_3_known, POSN_8_table, PredictedCoder

def POSN_1_positions(chunk, header, faces, states):
    """The positions of the geometric vertices in doubles."""
    n = header.geometric
    must(n or not chunk.data, "POSN-1", "a payload without vertices")
    if n == 0: return np.zeros((0, 3))
    coder = Coder(chunk)
    order = POSN_10_order(coder.raw(2), faces, n)
    number = {v: i for i, v in enumerate(order)}
    ordered = [tuple(number[v] for v in face) for face in faces]
    decode = POSN_9_positions if header.coder == LATTICE else FLT_positions
    positions = decode(coder, ordered, n, header, states)
    chunk.end()
    debug("order: %s\npositions in this order: %s", order, positions)
    return positions[[number[v] for v in range(n)]]

def POSN_9_positions(coder, faces, n, header, states):
    """[POSN-9, POSN-11, POSN-13]"""
    table, guesses, replaces, known = POSN_8_table(coder), coder.raw(1), coder.raw(1), POSN_3_known(faces, n)
    lattice = PredictedCoder(coder, known, table, header.cells, guesses, states)
    v = 0
    while v < n:
        pair = v + 1 < n and known[v + 1].faces and all(v not in face[:2] for face in known[v + 1].faces)
        turns = [lattice.vertex(u) for u in ([v, v + 1] if pair else [v])]
        list(zip(*turns))  # one number of each in turn
        v += len(turns)
    positions = POSN_2_positions(lattice.rows, header)
    if replaces:
        POSN_11_replace(coder, positions)
    return positions

def POSN_11_replace(coder, positions):
    count = NumberModel().decode(coder)
    must(count <= positions.size, "POSN-11", f"{count} replacements")
    gaps, at, flat = NumberModel(), -1, positions.reshape(-1)
    for _ in range(count):
        at += 1 + gaps.decode(coder)
        value = np.uint32(coder.raw(32)).view(np.float32)
        must(at < flat.size, "POSN-11", "a replacement is out of range")
        must(np.isfinite(value), "POSN-11", "a replacement is not finite")
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
        for _, a, b in at[v]:
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

def FLT_positions(coder, faces, n, header, states):
    """[FLT-2] for the units"""
    largest = np.maximum(np.abs(header.box_min), np.abs(header.box_max)).astype("<f4").view("<u4")
    floats = FloatCoder(coder, POSN_3_known(faces, n), [FLT_2_last_place(z) - 3 for z in largest.tolist()])
    patterns = [[FLT_1_bits(ordinal) for ordinal in floats.decode(v)] for v in range(n)]
    return np.array(patterns, dtype="<u4").view("<f4").astype(np.float64)
