"""The plain form of a stream: plain.md, rules PLN and CON-5, CON-7, CON-8."""
import math
from types import SimpleNamespace

import numpy as np

from container import FLOATS, KINDS, VOXELS, must, unzigzag

def PLN_1_is_plain(header, chunks):
    """Of all chunks of a stream."""
    forms = {chunk.is_compact for chunk in chunks if chunk.tag in KINDS and chunk.tag != "ATTR"}
    is_plain = not any(chunk.is_compact for chunk in chunks)
    must(is_plain or forms <= {True}, "PLN-1", "chunks of both forms")
    must(not is_plain or header.coder != VOXELS, "PLN-1", "voxel edges in the plain form")
    return is_plain

def CON_5_array(r, count, width=32):
    """`count` unsigned numbers."""
    numbers, planes = np.zeros(count, dtype="<u8"), r.u8() if count else 0
    must(8 * planes <= width, "CON-5", f"{planes} byte planes of numbers of {width} bits")
    for plane in range(planes):
        numbers |= np.frombuffer(r.bytes(count), dtype="u1").astype("<u8") << np.uint64(8 * plane)
    return numbers

def CON_7_differences(r, count, width=32):
    codes = CON_5_array(r, count, width)
    steps = np.where(codes % 2 == 1, ~(codes >> np.uint64(1)), codes >> np.uint64(1))
    return np.cumsum(steps, dtype="<u8") & np.uint64(2**width - 1)

def CON_8_indices(r, count):
    indices, fresh = [], 0
    for code in CON_5_array(r, count).tolist():
        indices.append((fresh - code) % 2**32)
        fresh = max(fresh, indices[-1] + 1)
    return indices

def PLN_2_faces(conn, seam, header):
    """[PLN-2, PLN-3] The faces over geometric vertices; those over vertices, and the geometric vertex of each of these."""
    indices = CON_8_indices(conn, 3 * header.triangles)
    conn.end()
    must(all(v < header.vertices for v in indices), "PLN-2", "a vertex out of range")
    geometric = list(range(header.vertices))
    if header.vertices > header.geometric:
        geometric, fresh = CON_8_indices(seam, header.vertices), 0
        for g in geometric:
            must(g <= fresh, "PLN-3", "a geometric vertex before the one below it")
            fresh += g == fresh
        must(fresh == header.geometric, "PLN-3", f"{fresh} geometric vertices")
    seam.end()
    faces = list(zip(indices[::3], indices[1::3], indices[2::3]))
    return [tuple(geometric[v] for v in face) for face in faces], SimpleNamespace(faces=faces, geometric=geometric, first=None)

def FGRP_1_plain(chunk, m):
    if not chunk.data:
        return None
    groups = CON_5_array(chunk, m).tolist()
    chunk.end()
    must(all(group < 2**16 for group in groups), "FGRP-1", "the number of a group")
    return groups

def PLN_4_deltas(chunk, s):
    """Rows of quantised x, y, z."""
    codes = CON_5_array(chunk, 3 * s).tolist()
    return [[unzigzag(code) for code in codes[i::s]] for i in range(s)]

def PLN_4_anchors(chunk, count):
    """Their vertices and cells."""
    vertices, *cells = (CON_7_differences(chunk, count).tolist() for _ in range(4))
    must(all(a < b for a, b in zip(vertices, vertices[1:])), "ANCH-3", "anchors that do not ascend")
    return zip(vertices, zip(*cells))

def PLN_5_positions(chunk, header):
    """The positions of the geometric vertices in doubles."""
    axes = [CON_7_differences(chunk, header.geometric) for _ in range(3)]
    chunk.end()
    if header.coder == FLOATS:
        return np.stack(axes, axis=1).astype("<u4").view("<f4").astype(np.float64)
    must(all(q <= cells for axis, cells in zip(axes, header.cells) for q in axis.tolist()), "PLN-5", "beyond the lattice")
    return np.array([[header.POSN_2_place(a, q) for q in axis.tolist()] for a, axis in enumerate(axes)]).T.reshape(-1, 3)

def PLN_6_values(r, a, n):
    """[PLN-6, PLN-7] The values of attribute a, a column for each component."""
    coding = r.u8()
    must(coding == 0 or coding == 1 and a.type == "f4" and a.k >= 3, "PLN-7", f"coding {coding} is not of this shape")
    columns = [PLN_6_column(r, a, n, coding and c < 3) for c in range(a.k)]
    if coding:
        x, y, z = columns[:3]
        length = np.sqrt(x * x + y * y + z * z)
        columns[:3] = [np.where(length > 0, axis / length, axis).astype("<f4") for axis in columns[:3]]
    return np.stack(columns, axis=1)

def PLN_6_column(r, a, n, is_direction):
    """One component, rounded to its type unless it is one of a direction."""
    step, size = r.number("d"), int(a.type[1])
    must(0 <= step < math.inf, "PLN-6", f"step {step}")
    first = r.number("q") if step else 0
    must(abs(first) <= 2**52, "PLN-6", f"first number {first}")
    must(not is_direction or 0 < step <= 1, "PLN-7", f"step {step} of a direction")
    if step == 0:
        return CON_7_differences(r, n, 8 * size).astype(f"<u{size}").view("<" + a.type)
    values = step * (first + CON_7_differences(r, n).astype("<i8")).astype(np.float64)
    if is_direction:
        return values
    limits = np.finfo(a.type) if a.type[0] == "f" else np.iinfo(a.type)
    whole = values if a.type[0] == "f" else np.floor(values + 0.5)
    return np.clip(whole, float(limits.min), float(limits.max)).astype("<" + a.type)
