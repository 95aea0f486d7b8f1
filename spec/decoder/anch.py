"""ANCH: anchors of highpass geometry: anch.md."""
from coder import Coder, NumberModel
from container import must, unzigzag
from plain import PLN_4_anchors

def ANCH_5_anchors(chunk, count):
    """[ANCH-3 to ANCH-5] Their vertices and cells."""
    coder, models, v, k = Coder(chunk), [NumberModel() for _ in range(4)], -1, (0, 0, 0)
    for _ in range(count):
        gap, *codes = (model.decode(coder) for model in models)
        v, k = v + gap + 1, tuple((x + unzigzag(code)) % 2**32 for x, code in zip(k, codes))
        yield v, k

def ANCH_1_read(chunk, header, n, components, is_plain):
    """The anchors' positions by their vertices, in rising order."""
    side = max(b - a for a, b in zip(header.box_min, header.box_max)) / (2**header.anchor_bits - 1)
    anchors, listed = {}, list((PLN_4_anchors if is_plain else ANCH_5_anchors)(chunk, header.anchors))
    chunk.end()
    for v, k in listed:
        must(v < n, "ANCH-3", f"anchor {v} is out of range")
        must(max(k) < 2**header.anchor_bits, "ANCH-4", f"cell {max(k)}")
        anchors[v] = [header.box_min[a] + side * float(k[a]) for a in range(3)]
    for component in components:  # [ANCH-2]
        held = sum(v in anchors for v in component)
        must(held, "ANCH-2", "a component has no anchor")
        must(held == len(component) or len(component) >= 8, "ANCH-2", "a vertex of a small component is no anchor")
    return anchors
