"""DELT: highpass geometry: delt.md but for the planned cycles."""
import numpy as np

from coder import Coder
from container import Reader, must, unzigzag
from cycles import DELT_7_positions
from fields import FLD_numbers

def is_solved(component):
    return len(component) >= 8

def DELT_2_deltas(chunk, header, around, solved):
    """The delta coordinates of the solved vertices in model units, in numbers of `solved`: s rows of x, y, z."""
    s, data = len(solved), chunk.data if chunk else b""
    if chunk and chunk.is_compact:
        q = DELT_5_compact(data, around, solved)
    else:
        r = Reader(data)
        codes = r.planes(3 * s) if data or s else []
        r.end()
        q = [[unzigzag(codes[a * s + i]) for a in range(3)] for i in range(s)]
    def delta(q):
        shift = header.shift_ones if abs(q) == 1 else header.shift_others
        r = 0 if q == 0 else (1 if q > 0 else -1) * (abs(q) - shift / 256)
        return header.step * r
    return np.array([[delta(x) for x in row] for row in q]).reshape(s, 3)

def DELT_5_compact(data, around, solved):
    number, coder = {v: i for i, v in enumerate(solved)}, Coder(data)
    q = FLD_numbers(coder, [[number[u] for u in around[v]] for v in solved])
    coder.end()
    return q

def DELT_4_least_squares(graph, deltas, places):
    """The solution on a graph whose vertices count from 0; `places` are the anchors' positions by their vertices."""
    n = len(graph)
    laplacian = np.eye(n)
    for i, around in enumerate(graph):
        laplacian[i, around] = -1 / len(around)
    normal, right = laplacian.T @ laplacian, laplacian.T @ deltas
    for a, place in places.items():
        normal[a, a] += 1
        right[a] += place
    return np.linalg.solve(normal, right)

def DELT_1_positions(chunks, header, around, components, anchors, dump):
    """The positions of the geometric vertices in doubles."""
    solved = sorted(v for c in components if is_solved(c) for v in c)
    deltas = DELT_2_deltas(chunks["DELT"], header, around, solved)
    row = {v: i for i, v in enumerate(solved)}
    positions = np.zeros((len(around), 3))
    for v, place in anchors.items():
        positions[v] = place
    centre = np.array([0.5 * a + 0.5 * b for a, b in zip(header.box_min, header.box_max)])
    places = {v: np.array(p) - centre for v, p in anchors.items()}
    dump("deltas", deltas)
    for c in [solved] if header.cycles else filter(is_solved, components):
        number = {v: i for i, v in enumerate(c)}
        graph = [[number[u] for u in around[v]] for v in c]
        held = {number[v]: places[v] for v in c if v in places}
        of_c = deltas[[row[v] for v in c]]
        x = DELT_7_positions(graph, of_c, held, header.cycles, dump) if header.cycles else DELT_4_least_squares(graph, of_c, held)
        positions[c] = x + centre
    must(np.all(np.abs(positions) <= 3.4028234663852886e38), "DELT-3", "a coordinate is not finite as f32")
    return positions
