"""FGRP: groups of faces: fgrp.md."""
from coder import Coder, NumberModel, bit_models, SymbolModel
from container import Reader, must


def FGRP_1_read(chunk, faces):
    """The group of every decoded face, or None."""
    if not chunk or not chunk.data:
        return None
    if chunk.is_compact:
        return FGRP_2_compact(chunk.data, faces)
    r = Reader(chunk.data)
    groups = r.planes(len(faces))
    r.end()
    must(all(g < 2**16 for g in groups), "FGRP-1", "a group is not below 2^16")
    return groups


def FGRP_2_compact(data, faces):
    coder = Coder(data)
    bits, kinds, numbers = bit_models(), SymbolModel((8, 4, 2, 2) + (1,) * 10 + (16, 1)), NumberModel()
    met, groups, recent, highest = {}, [], [], -1
    for face in faces:
        around = [met[x] for x in face if x in met]
        forecast = around[0] if around else groups[-1] if groups else 0
        c, d = len(around), int(len(set(around)) > 1)
        group = forecast
        if not bits[2 * c + d].decode(coder):
            group = FGRP_3_other(coder, kinds, numbers, [g for g in recent if g != forecast], highest)
        must(group < 2**16, "FGRP-1", "a group is not below 2^16")
        groups.append(group)
        highest = max(highest, group)
        recent = ([group] + [g for g in recent if g != group])[:14]
        met.update((x, group) for x in face)
    coder.end()
    return groups


def FGRP_3_other(coder, kinds, numbers, others, highest):
    s = coder.symbol([kinds])
    if s < 14:
        must(s < len(others), "FGRP-3", "a recent group that is not there")
        return others[s]
    return highest + 1 if s == 14 else numbers.decode(coder)
