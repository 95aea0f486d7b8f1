"""ANCH: anchors of highpass geometry: anch.md."""
from coder import Coder, NumberModel
from container import must, unzigzag

def ANCH_1_read(chunk, header, n, components):
    """The anchors' positions by their vertices, in rising order."""
    count = header.anchors
    if chunk.is_compact:
        coder, models = Coder(chunk), [NumberModel() for _ in range(4)]
        numbers = [[model.decode(coder) for model in models] for _ in range(count)]  # [ANCH-5]
    else:
        gaps, cells = chunk.planes(count), chunk.planes(3 * count)
        numbers = [[gaps[i]] + cells[i::count] for i in range(count)]
    chunk.end()
    side = max(b - a for a, b in zip(header.box_min, header.box_max)) / (2**header.anchor_bits - 1)
    anchors, v, k = {}, -1, [0, 0, 0]
    for gap, *codes in numbers:  # [ANCH-3]
        v += gap + 1
        must(v < n, "ANCH-3", f"anchor {v} is out of range")
        k = [(k[a] + unzigzag(codes[a])) % 2**32 for a in range(3)]  # [ANCH-4]
        must(max(k) < 2**header.anchor_bits, "ANCH-4", f"cell {max(k)}")
        anchors[v] = [header.box_min[a] + side * float(k[a]) for a in range(3)]
    for component in components:  # [ANCH-2]
        held = sum(v in anchors for v in component)
        must(held, "ANCH-2", "a component has no anchor")
        must(held == len(component) or len(component) >= 8, "ANCH-2", "a vertex of a small component is no anchor")
    return anchors
