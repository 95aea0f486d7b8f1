"""FGRP: groups of faces: fgrp.md."""
from coder import Coder, NumberModel, SymbolModel, bit_models
from container import must

def FGRP_1_read(chunk, faces):
    """The group of every decoded face, or None."""
    if not chunk.data:
        return None
    groups = FGRP_2_compact(Coder(chunk), faces)
    chunk.end()
    return groups

def FGRP_2_compact(coder, faces):
    bits, met, groups, recent, numbers, highest = bit_models(), {}, [], [], NumberModel(), -1
    kinds = SymbolModel((8, 4, 2, 2) + (1,) * 10 + (16, 1))
    for face in faces:
        around = [met[x] for x in face if x in met]
        group = forecast = around[0] if around else groups[-1] if groups else 0
        if not bits[2 * len(around) + (len(set(around)) > 1)].decode(coder):
            s, others = coder.symbol([kinds]), [g for g in recent if g != forecast]  # [FGRP-3]
            must(s >= 14 or s < len(others), "FGRP-3", "a recent group that is not there")
            group = others[s] if s < 14 else highest + 1 if s == 14 else numbers.decode(coder)
            must(group < 2**16, "FGRP-1", f"group {group}")
        groups.append(group)
        highest, recent = max(highest, group), ([group] + [g for g in recent if g != group])[:14]
        met.update((x, group) for x in face)
    return groups
