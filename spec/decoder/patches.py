"""Patched parts of maps: map.md, MAP-17."""
import copy
import struct
from types import SimpleNamespace

import numpy as np
import xxhash

from coder import BitModel, Coder, CountedBit, NumberModel
from container import Reader, must, unzigzag
from graph import MAP_11_ends, open_edges
from mesh import Mesh
from vectors import square

MOST_PATCHES, MOST_CANDIDATES = 16, 4

def MAP_3_key(r):
    """The key of a part."""
    level = r.u8()
    must(level <= 24, "MAP-3", f"level {level}")
    return (level,) + tuple(unzigzag(r.varint(2**32 - 1, "CON-2")) for _ in range(3))

def MAP_17_part(described, key, octets):
    """The mesh of the part `key`, whose octets are a base and a patch."""
    patches = []
    while octets[:1] == b"\4":
        must(len(patches) < MOST_PATCHES, "MAP-17", "more than 16 patches")
        r = Reader(octets[1:])
        base_key = MAP_3_key(r)
        octets = r.bytes(r.varint())
        patches.append((key, octets, r.rest()))
        key = base_key
    mesh = described.MAP_7_part(key, octets)
    for key, base, patch in reversed(patches):
        mesh = MAP_17_apply(described, key, mesh, struct.pack("<Q", xxhash.xxh3_64_intdigest(base)), patch)
    return mesh

def MAP_17_apply(described, key, base, base_hash, patch):
    r = Reader(described.checked(key, patch, "MAP-17", base_hash))
    plan, octets = r.bytes(r.varint()), r.rest()
    must(octets[:1] != b"\4", "MAP-17", "the inserted part is patched")
    if not plan:
        must(octets, "MAP-17", "neither a plan nor a part")
        return described.MAP_7_covered(key, octets, base)
    plan = Coder(Reader(plan))
    stays = MAP_17_staying(plan, base.faces)
    inserted = described.MAP_7_covered(key, octets) if octets else no_part_like(base)
    must(base.groups is None and inserted.groups is None, "MAP-17", "groups of faces")
    must(any(stays), "MAP-17", "no face stays")
    kept = [face for face, stay in zip(base.faces, stays) if stay]
    joins = MAP_17_joined(plan, base, kept, inserted)
    plan.CMP_3_end()
    return MAP_17_put_together(base, kept, inserted, joins)

def no_part_like(base):  # MAP-17
    mesh = Mesh()
    mesh.positions, mesh.faces, mesh.groups, mesh.border = base.positions[:0], [], None, {}
    mesh.attributes = copy.deepcopy(base.attributes)
    for a in mesh.attributes:
        a.values = a.values[:0]
    return mesh

def MAP_17_staying(plan, faces):
    """For every face whether it stays. A model's number is 8 s + 2 g + (1 if the face before stays)."""
    models = [CountedBit(2**15 if s == g else 15 * 2**12 if s > g else 2**12) for s in range(4) for g in range(4) for _ in range(2)]
    last, stays = {}, []
    for f, face in enumerate(faces):
        count = [0, 0]
        for k in range(3):
            edge = tuple(sorted((face[k], face[(k + 1) % 3])))
            if last.get(edge, f) != f:
                count[stays[last[edge]]] += 1
            last[edge] = f
        before = stays[-1] if stays else 1
        stays.append(models[8 * count[1] + 2 * count[0] + before].decode(plan))
    return stays

def MAP_17_joined(plan, base, kept, inserted):
    """Of inserted vertices the base's vertex that they are joined to."""
    models = SimpleNamespace(joins=[BitModel() for _ in range(6)], candidates=NumberModel(), places=NumberModel())
    edges = open_edges(kept, len(base.positions))
    by_place = sorted((v for v in range(len(edges)) if edges[v]), key=lambda v: (*base.positions[v], v))
    twins, is_twin, joins, taken = {}, CountedBit(15 * 2**12), {}, set()
    for v in by_place:
        twins.setdefault(tuple(base.positions[v]), v)
    for v, on, context in MAP_11_ends(inserted.faces, len(inserted.positions), joins):
        if context is None:
            continue
        twin = twins.get(tuple(inserted.positions[v]))
        if twin is not None and twin not in taken and is_twin.decode(plan):
            joins[v] = twin
            taken.add(twin)
            continue
        if not models.joins[context].decode(plan):
            continue
        place = inserted.positions[v].astype(float)
        near = edges[joins[on[-1]]][:MOST_CANDIDATES] if on else []
        near = sorted((u for u in near if u not in taken), key=lambda u: (square(place - base.positions[u]), u))
        number = models.candidates.decode(plan) if near else 0
        must(number <= len(near), "MAP-17", f"candidate {number}")
        if number < len(near):
            to = near[number]
        else:
            at = sum(base.positions[u][0] < place[0] for u in by_place) + unzigzag(models.places.decode(plan))
            must(0 <= at < len(by_place), "MAP-17", f"place {at}")
            to = by_place[at]
        must(to not in taken, "MAP-17", "two vertices are joined to one")
        taken.add(to)
        joins[v] = to
    return joins

def MAP_17_put_together(base, kept, inserted, joins):
    rows = sorted({v for face in kept for v in face})
    number = {v: i for i, v in enumerate(rows)}
    new = [v for v in range(len(inserted.positions)) if v not in joins]
    new_number = {v: number[u] for v, u in joins.items()} | {v: len(rows) + i for i, v in enumerate(new)}
    mesh = Mesh()
    mesh.header, mesh.exact, mesh.groups = base.header, False, None
    mesh.positions = mesh.of_stream = np.concatenate([base.positions[rows], inserted.positions[new]])
    mesh.attributes = copy.deepcopy(base.attributes)
    for mine, a, b in zip(mesh.attributes, base.attributes, inserted.attributes):
        mine.values = np.concatenate([a.values[rows], b.values[new]])
    mesh.faces = [tuple(number[v] for v in face) for face in kept]
    mesh.faces += [tuple(new_number[v] for v in face) for face in inserted.faces]
    mesh.border = {number[v]: point for v, point in base.border.items() if v in number}
    mesh.border |= {new_number[v]: point for v, point in inserted.border.items() if v not in joins}
    return mesh
