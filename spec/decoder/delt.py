"""DELT: highpass geometry: delt.md but for the levels and cycles."""
from logging import debug

import numpy as np

from coder import Coder
from container import LARGEST_F32, must
from cycles import DELT_7_positions
from fields import FLD_numbers
from graph import subgraph
from plain import PLN_4_deltas

def DELT_2_deltas(chunk, header, around, solved, is_plain):
    """The delta coordinates of the solved vertices in model units, in numbers of `solved`: s rows of x, y, z."""
    s = len(solved)
    if is_plain:
        q = PLN_4_deltas(chunk, s)
    else:
        q = FLD_numbers(Coder(chunk), subgraph(around, solved))  # [DELT-5]
    chunk.end()
    def delta(q):
        shift = header.shift_ones if abs(q) == 1 else header.shift_others
        r = 0 if q == 0 else (1 if q > 0 else -1) * (abs(q) - shift / 256)
        return header.step * r
    return np.array([[delta(x) for x in row] for row in q]).reshape(s, 3)

def DELT_1_positions(chunk, header, around, components, anchors, is_plain):
    """The positions of the geometric vertices in doubles."""
    components = [c for c in components if len(c) >= 8]
    solved = sorted(v for c in components for v in c)
    deltas, positions = np.zeros((len(around), 3)), np.zeros((len(around), 3))
    deltas[solved] = DELT_2_deltas(chunk, header, around, solved, is_plain)
    for v, place in anchors.items():
        positions[v] = place
    centre = np.array([0.5 * a + 0.5 * b for a, b in zip(header.box_min, header.box_max)])
    debug("deltas: %s", deltas)
    for c in components:  # [DELT-4]
        graph, places = subgraph(around, c), {i: positions[v] - centre for i, v in enumerate(c) if v in anchors}
        positions[c] = DELT_7_positions(graph, deltas[c], places, header.cycles) + centre
    must(np.all(np.abs(positions) <= LARGEST_F32), "DELT-3", "a coordinate is not finite as f32")
    return positions
