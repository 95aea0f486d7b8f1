"""Parts of maps: map.md, MAP-2, MAP-5 to MAP-7, MAP-11, MAP-20 and MAP-24."""
import copy
import math
import struct

import numpy as np
import xxhash

from attr import COLOUR, MEASURES, Attribute
from attr_colors import ATTR_46_value
from coder import BitModel, Coder, CountedBit, NumberModel, States
from container import (CNT_1_stream, CNT_2_checked, CNT_4_chunks, HIGHPASS, Header, Reader, VOXELS, must,
                       unzigzag)
from graph import MAP_11_ends
from known import Known, MAP_30_level
from mesh import decode_chunks
from messages import MAP_1_fields
from patches import MAP_17_part

class Map:
    """[MAP-5] The fields of a map's message, and [MAP-6] the primers with the states before each, and after the last."""
    def __init__(self, message):  # MAP-1, MAP-5, MAP-6
        self.hash, r = xxhash.xxh3_64_intdigest(message), MAP_1_fields(message, 1)
        self.id, self.epoch, self.frame = r.number("Q"), r.number("I"), r.bytes(r.u8())
        self.origin, self.step = [r.number("d") for _ in range(3)], 2.0**r.number("b")
        self.cell_steps, self.cell_origin = r.varint(), [unzigzag(r.varint()) for _ in range(3)]
        self.grid = self.MAP_5_grid(r)
        self.attributes = [Attribute(r) for _ in range(r.u8())]
        must(all(a.is_shortest for a in self.attributes), "MAP-5", "a descriptor that is longer than it need be")
        self.primers, self.states = [], [None]
        for _ in range(r.u8()):
            stream, coded_border = r.bytes(r.varint()), r.bytes(r.varint())
            self.primers.append((CNT_1_stream(stream, Attribute), coded_border))
            self.states.append(self.decode(self.primers[-1], self.states[-1])[1])
        r.end()

    def MAP_5_grid(self, r):
        """Origin and edges of the map's grid, or None."""
        grids = r.u8()
        must(grids <= 1, "MAP-5", f"{grids} grids")
        if not grids:
            return None
        origin, edges = ([r.number("d") for _ in range(3)] for _ in range(2))
        must(np.all(np.isfinite(origin + edges)) and min(edges) > 0, "MAP-5", f"a grid at {origin} with edges {edges}")
        return origin, edges

    def decode(self, coded, before, base=None):
        """A part's mesh [MAP-7, MAP-11], and the models that it leaves; `before` are those that it begins with; `base`: what it is coded beside, or None."""
        ((header, chunks), border), states = coded, States(before)
        known = Known(base, header) if base and header.coder == VOXELS else None  # [MAP-26]
        mesh = decode_chunks(header, copy.deepcopy(chunks), states, known)
        streamed = mesh.positions.copy()
        mesh.border = MAP_11_border(self, mesh, Coder(Reader(border)), states, base) if border else {}
        mesh.of_stream = mesh.positions.copy()
        mesh.of_stream[list(mesh.border)] = streamed[list(mesh.border)]
        return mesh, states.after

    def corner(self, key):
        """[MAP-3] The lowest corner of the cell of a part, relative to the map's origin."""
        level, *cell = key
        return [self.step * (x * 2**level * self.cell_steps + o) for x, o in zip(cell, self.cell_origin)]

    def checked(self, key, octets, tag="MAP-7", before=b""):  # MAP-7, MAP-17
        """The octets before the checksum, which is of the part `key`."""
        seed = xxhash.xxh3_64_intdigest(struct.pack("<QBiii", self.hash, *key))
        return CNT_2_checked(octets, tag, seed, before)

    def MAP_7_part(self, key, octets, base=None):
        """The mesh of a part, relative to the map's origin; `key` is (level, x, y, z)."""
        if octets[:1] == b"\4":
            return MAP_17_part(self, key, octets)
        return self.MAP_7_covered(key, self.checked(key, octets), base)

    def MAP_7_covered(self, key, octets, base=None):
        """The same of octets without their checksum."""
        r = Reader(octets)
        if octets[0] & 1:
            must(len(octets) == 2 and octets[0] == 1 and octets[1] < len(self.primers), "MAP-7", "no primer")
            return self.decode(self.primers[octets[1]], self.states[octets[1]], base)[0]
        header = PartHeader(r, self.corner(key), self.grid)
        border, shapes = r.bytes(r.varint()), iter(self.attributes)
        chunks = CNT_4_chunks(r, header, lambda _: next(shapes, None))
        tags = [chunk.tag for chunk in chunks]
        must(tags.count("ATTR") == len(self.attributes), "MAP-7", f"{tags.count('ATTR')} attributes")
        must("ORDR" not in tags, "MAP-7", "a part with an order")
        return self.decode(((header, chunks), border), self.states[-1], base)[0]

class PartHeader(Header):
    """[MAP-7]"""
    def __init__(self, r, corner, grid):
        self.corner = corner
        self.HDR_5_counts(r)
        if self.flags & 2:
            must(self.coder == VOXELS and not self.flags & 0x38 and grid, "MAP-7", f"flags {self.flags}")
            self.levels, (self.lattice_origin, edges) = self.HDR_14_levels(r), grid
            width = 2 * self.levels
            self.steps = [edge / width for edge in edges]
            self.HDR_14_steps()
            pairs = [(unzigzag(r.varint()), r.varint()) for _ in range(3)]
            self.first = [width * (f + v) for (f, _), v in zip(pairs, self.before(width))]
            self.cells = [width * cells for _, cells in pairs]
            self.HDR_14_reach()
        else:
            self.geometry(r)

    def first_point(self, r):
        return [f + b for f, b in zip(super().first_point(r), self.before(1))]

    def before(self, width):
        """Widths of so many steps from the lattice's origin to the cell's corner."""
        widths = [(c - o) / (width * s) for c, o, s in zip(self.corner, self.lattice_origin, self.steps)]
        return [math.floor(w) if abs(w) <= 2**48 else 0 for w in widths]

def MAP_11_former(base):
    """Of the base's positions, as bytes: point and twin of the first vertex there, or None."""
    former = {}
    for v, position in enumerate(base.of_stream if base else []):
        former.setdefault(position.tobytes(), base.border.get(v))
    return former

def MAP_11_border(lattice, mesh, coder, states, base=None):
    """Moves the border's vertices to their points; their points and twins."""
    learnt = states.models("border", bits=[BitModel(2**8)] + [BitModel(2**15) for _ in range(6)], twin=NumberModel(),
                           ways=[NumberModel() for _ in range(6)])
    nearest = np.clip(np.floor(mesh.positions / lattice.step + 0.5), 1 - 2**24, 2**24 - 1).astype(int)
    header, points, twins = mesh.header, {}, {}
    former, is_same, unmoved = MAP_11_former(base), CountedBit(64000), [CountedBit(256)] + [CountedBit(2048) for _ in range(6)]
    for v, on, context in MAP_11_ends(mesh.faces, len(nearest), points):
        place = mesh.positions[v].tobytes()
        if former.get(place) and is_same.decode(coder):
            points[v], twins[v] = np.array(former[place][0]), former[place][1]
            continue
        bits = unmoved if former.get(place, True) is None else learnt.bits
        if not bits[0 if context is None else 1 + context].decode(coder):
            continue
        twins[v], expected = learnt.twin.decode(coder), nearest[v]
        if header.coder == HIGHPASS and on:
            expected = expected + points[on[-1]] - nearest[on[-1]]
        loose = [True] * 3
        if header.coder == VOXELS:
            axes = zip(mesh.positions[v].tolist(), header.lattice_origin, header.steps)
            steps = [math.floor((x - o) / s + 0.5) for x, o, s in axes]
            loose = [x % 2 == 1 or abs(x) >= 2**50 for x in steps]
        ways = [unzigzag(learnt.ways[3 * loose[a] + a].decode(coder)) for a in range(3)]
        points[v] = expected + ways
        must(np.all(abs(points[v]) < 2**24), "MAP-11", f"point {points[v]}")
    must(points, "MAP-11", "no border vertex")
    MAP_24_colours(mesh, list(points), coder, states)
    coder.CMP_3_end()
    if header.coder == HIGHPASS:
        MAP_20_move_along(mesh, {v: lattice.step * point - mesh.positions[v] for v, point in points.items()})
    for v, point in points.items():
        mesh.positions[v] = lattice.step * point
    return {v: (tuple(point), twins[v]) for v, point in points.items()}

def MAP_24_colours(mesh, border, coder, states):
    """Gives the border's vertices colours on levels that all parts have."""
    learnt = states.models("border colours", step=NumberModel(), moved=[BitModel(2**14) for _ in range(12)],
                           away=[BitModel(2**14) for _ in range(12)], more=NumberModel())
    for a in mesh.attributes:
        if a.kind != COLOUR or a.type not in MEASURES:
            continue
        s = learnt.step.decode(coder)
        must(s <= 255, "MAP-24", f"step {s}")
        for v in border if s else []:
            w = None
            for c in range(a.k):
                x = MAP_30_level(a.values[v, c], a.type, 8)
                e = (2 * x + s) // (2 * s)
                r = 2 * (x - e * s)
                d = -1 if r < 0 else 1
                m = min(2, 3 * abs(r) // (s + 1)) + (0 if w is None else 3 if w == 0 else 6 if w * d > 0 else 9)
                w = 0
                if learnt.moved[m].decode(coder):
                    w = -d if learnt.away[m].decode(coder) else d
                    w *= 1 + min(learnt.more.decode(coder), 255)
                a.values[v, c] = ATTR_46_value(min(max((e + w) * s, 0), 255), a.type, 8)

def MAP_20_move_along(mesh, border):
    """What is not on the border moves along, less with each edge; `border`: the ways of its vertices."""
    numbers = {}
    of = [numbers.setdefault(row.tobytes(), len(numbers)) for row in np.float32(mesh.positions)]
    ways, fixed = np.zeros((len(numbers), 3)), np.zeros(len(numbers), bool)
    for v, way in border.items():
        ways[of[v]], fixed[of[v]] = way, True
    edges = np.array([(of[face[k]], of[face[(k + 1) % 3]]) for face in mesh.faces for k in range(3)])
    weights = np.bincount(edges.ravel(), minlength=len(numbers))
    for _ in range(16):
        sums = np.zeros_like(ways)
        np.add.at(sums, edges.ravel(), ways[edges[:, ::-1]].reshape(-1, 3))
        ways = np.where(fixed[:, None], ways, sums / np.maximum(weights, 1)[:, None])
    mesh.positions[:] = np.float32(mesh.positions + ways[of])
