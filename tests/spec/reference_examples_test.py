#!/usr/bin/python3
"""Decodes the worked examples of the specification with the reference decoder, and compares with the values beside them."""
import os
import struct
import sys
from types import SimpleNamespace

import numpy as np

from reference_decoder_test import ROOT
from anch import ANCH_1_read
from attr import ATTR_2_values, Surface, TYPES
from coder import Coder, States
from container import Chunk, DIR_2_chunk, FLOATS, Header, LATTICE, Reader, VOXELS
from delt import DELT_1_positions
from fgrp import FGRP_1_read
from fields import FLD_numbers
from glue import CONN_8_faces
from grid import GRD_12_read
from known import Known
from graph import components, neighbours
from mesh import decode_chunks
from messages import MAP_25_whole, Pose
from ordr import ORDR_1_read
from parts import Map
from patches import MAP_17_joined, MAP_17_staying
from plain import FGRP_1_plain, PLN_2_faces, PLN_5_positions, PLN_6_values
from posn import POSN_1_positions
from seam import SEAM_1_read

TWO = [(0, 1, 2), (2, 1, 3)]


def line(file, name, kind=int):
    """The numbers of the first line of a file of spec/ that starts with this name."""
    with open(os.path.join(ROOT, "spec", file), encoding="utf-8") as text:
        words = next(x for x in text if x.startswith(f"    {name}:")).split()[1:]
    return bytes.fromhex("".join(words)) if kind is bytes else [kind(x) for x in words]


def chunk(file, name="compact"):
    return Chunk(is_compact=file != "plain.md" and name != "anchors", data=line(file, name, bytes))


def triples(numbers):
    return [tuple(numbers[i:i + 3]) for i in range(0, len(numbers), 3)]


def lattice(coder, n, **more):
    fields = {"steps": [1.0] * 3, "lattice_origin": [0.0] * 3, "first": [0] * 3, "coder": coder, "geometric": n, "levels": 1}
    header = SimpleNamespace(**{**fields, **more})
    header.POSN_2_place = lambda axis, q: Header.POSN_2_place(header, axis, q)
    return header


def positions(file, header, faces):
    return POSN_1_positions(chunk(file, "payload"), header, faces, States()).astype("f4")


def attribute(file, kind, type_number, k, others=(), name="payload"):
    surface = Surface(SEAM_1_read(Chunk(), TWO, 4, 4), np.array(line("posn.md", "q"), dtype="f4").reshape(4, 3), TWO, list(others), States())
    described = SimpleNamespace(kind=kind, type=TYPES[type_number], k=k, name=b"")
    described.is_shape = lambda kind, types, counts: described.kind == kind and described.type in types and described.k in counts
    surface.attributes.append(described)
    data = line(file, name, bytes)
    described.values = ATTR_2_values(Chunk(is_compact=file != "plain.md", data=data, descriptor=described), surface)
    return described


def highpass():
    header = SimpleNamespace(anchors=2, anchor_bits=4, box_min=[0, 0, 0], box_max=[3, 1, 1.5], step=0.25, shift_ones=32, shift_others=16, cycles=1)
    around = neighbours(triples(line("delt.md", "faces")), 8)
    anchors = ANCH_1_read(chunk("delt.md", "anchors"), header, 8, components(around), True)
    return DELT_1_positions(chunk("delt.md"), header, around, components(around), anchors, False)


def plain():
    """The examples of plain.md."""
    header = SimpleNamespace(triangles=2, vertices=5, geometric=4)
    faces, seams = PLN_2_faces(chunk("plain.md", "conn"), chunk("plain.md", "seam"), header)
    yield "plain.md faces", seams.faces, line("plain.md", "faces")
    yield "plain.md geometric", seams.geometric, line("plain.md", "geometric")
    yield "plain.md geometric faces", faces, [0, 1, 2, 2, 1, 3]
    yield "plain.md groups", FGRP_1_plain(chunk("plain.md", "fgrp"), 2), line("plain.md", "groups")
    yield "plain.md positions", PLN_5_positions(chunk("plain.md", "posn"), lattice(LATTICE, 4, cells=[4, 4, 3])), line("plain.md", "q")
    for name, kind, number, values in (("exact", "u1", int, "bytes"), ("steps", "f4", np.float32, "values")):
        described = SimpleNamespace(type=kind, k=1)
        yield f"plain.md {name}", PLN_6_values(chunk("plain.md", name), described, 5), line("plain.md", values, number)
    header = SimpleNamespace(anchors=2, anchor_bits=12, box_min=[0] * 3, box_max=[4095] * 3)
    anchors = ANCH_1_read(chunk("plain.md", "anch"), header, 4, [], True)
    yield "plain.md anchors", list(anchors), line("plain.md", "anchors")
    yield "plain.md cells", list(anchors.values()), line("plain.md", "cells")


def stream():
    header, r = Header(Reader(line("format.md", "header", bytes))), Reader(line("format.md", "chunks", bytes))
    chunks = []
    while r.at < len(r.data):
        chunks.append(DIR_2_chunk(r, header, None))
    return decode_chunks(header, chunks, States())


def mesh_of(which):
    """A mesh of the examples of patches, without attributes."""
    positions = np.float32(triples(line("map.md", f"{which}-q")))
    return SimpleNamespace(positions=positions, of_stream=positions, faces=triples(line("map.md", f"{which}-faces")), attributes=[])


def patches():
    """The examples of map.md of a patch with a plan and of a part beside its base."""
    base, new, plan = mesh_of("base"), mesh_of("new"), Coder(Reader(line("map.md", "plan", bytes)))
    stays = MAP_17_staying(plan, base.faces)
    yield "map.md kept", stays, line("map.md", "kept")
    joins = MAP_17_joined(plan, base, [face for face, stay in zip(base.faces, stays) if stay], new)
    plan.CMP_3_end()
    yield "map.md joined", [joins.get(v, -1) for v in range(5)], line("map.md", "joined")
    colours = SimpleNamespace(kind=1, type="u1", k=3, name=b"", values=np.array(triples(line("map.md", "base-colours")), dtype="u1"))
    base.attributes = [colours]
    header = lattice(VOXELS, 6, cells=[8, 8, 8], levels=2, triangles=8)
    known = Known(base, header)
    faces, points = GRD_12_read({"GRID": chunk("map.md", "grid"), "CONN": Chunk()}, header, States(), known)
    yield "map.md faces beside a base", faces, line("map.md", "whole-faces")
    yield "map.md positions beside a base", points, line("map.md", "whole-q")
    surface = Surface(SEAM_1_read(Chunk(), faces, 6, 6), np.float32(points), faces, [colours], States(), known)
    yield "map.md colours", ATTR_2_values(Chunk(is_compact=True, data=line("map.md", "colours", bytes), descriptor=colours), surface), \
        line("map.md", "whole-colours")


def examples():
    """Names, decoded values and those of the text."""
    yield from plain()
    yield "conn.md", CONN_8_faces(chunk("conn.md"), 2, 4, States()), line("conn.md", "faces")
    yield "seam.md", SEAM_1_read(chunk("seam.md"), TWO, 4, 6).faces, line("seam.md", "faces")
    yield "fgrp.md", FGRP_1_read(chunk("fgrp.md"), TWO), line("fgrp.md", "groups")
    yield ("ordr.md", np.hstack(ORDR_1_read(chunk("ordr.md"), TWO, 4)),
           line("ordr.md", "vertices") + line("ordr.md", "faces") + line("ordr.md", "rotations"))
    header = SimpleNamespace(anchors=2, anchor_bits=12, box_min=[0] * 3, box_max=[4095] * 3)
    yield "anch.md", list(ANCH_1_read(chunk("anch.md"), header, 4, [], False).values()), [0, 0, 100, 4095, 2000, 50]
    yield "delt.md", highpass(), line("delt.md", "positions", float)
    yield "compact.md", FLD_numbers(Coder(Reader(bytes.fromhex("7557588af8b4094417e8333511"))), neighbours([(0, 1, 2), (1, 3, 2)], 4)), \
        [1, 0, 3, 1, -2, 3, 1, -2, 3, 40, -80, 9]
    yield "posn.md", positions("posn.md", lattice(LATTICE, 4, cells=[4, 4, 3]), TWO), line("posn.md", "q")
    chunks = {tag: chunk("grid.md", name) for tag, name in (("GRID", "payload"), ("CONN", "conn"))}
    faces, points = GRD_12_read(chunks, lattice(VOXELS, 8, cells=[8, 8, 8], levels=2, triangles=10), States())
    yield "grid.md faces", faces, line("grid.md", "faces")
    yield "grid.md positions", points, line("grid.md", "q")
    box_max = [1.0, struct.unpack("<f", struct.pack("<f", 1.1))[0], 0.5]
    yield ("posn_floats.md", positions("posn_floats.md", lattice(FLOATS, 4, box_min=[0.0] * 3, box_max=box_max), TWO),
           line("posn_floats.md", "values", np.float32))
    yield "attr_lattice.md", attribute("attr_lattice.md", 3, 3, 1).values, line("attr_lattice.md", "values")
    yield "attr_colors.md", attribute("attr_colors.md", 1, 1, 3).values, line("attr_colors.md", "values")
    yield "attr_haar.md", attribute("attr_haar.md", 1, 1, 3).values, line("attr_haar.md", "values")
    yield "attr_normals.md", attribute("attr_normals.md", 0, 6, 3).values, line("attr_normals.md", "values", np.float32)
    uvs, joints = attribute("attr_uvs.md", 2, 6, 2), attribute("attr_skin.md", 5, 1, 4)
    yield "attr_uvs.md", uvs.values, line("attr_uvs.md", "values", np.float32)
    yield "attr_tangents.md", attribute("attr_tangents.md", 4, 6, 4, [uvs]).values, line("attr_tangents.md", "values", np.float32)
    yield "attr_skin.md joints", joints.values, line("attr_skin.md", "joints")
    yield "attr_skin.md weights", attribute("attr_skin.md", 6, 1, 4, [joints], "weights-payload").values, line("attr_skin.md", "weights")
    whole = Map(line("map.md", "message", bytes))
    for x in (0, 1):
        part = whole.MAP_7_part((0, x, 0, 0), line("map.md", f"part-{x}", bytes))
        yield f"map.md part {x}", np.float32(part.positions), line("map.md", f"decoded-{x}", np.float32)
        yield f"map.md border {x}", list(part.border), line("map.md", f"border-{x}")
    message, pieces = line("map.md", "pose", bytes), [line("map.md", f"fragment-{x}", bytes) for x in range(3)]
    pose = Pose(message)
    yield "map.md pose", pose.rotation + pose.translation, [0.5] * 4 + [1, 2, -0.5]
    yield "map.md pose's numbers", (pose.map, pose.start, pose.number, pose.stamp), (whole.hash, 1, 5, 1500000000)
    yield "map.md fragments", list(MAP_25_whole(pieces[::-1])), list(message)
    yield "map.md fragments but one", [MAP_25_whole(pieces[1:])], [None]
    yield "map.md no fragments", [MAP_25_whole([])], [None]
    yield from patches()
    mesh = stream()
    yield "format.md faces", mesh.faces, line("format.md", "faces")
    yield "format.md positions", mesh.positions, line("format.md", "positions", np.float32)


def main():
    failed = 0
    for name, own, expected in examples():
        own, expected = np.array(own).reshape(-1), np.array(expected)
        is_same = own.shape == expected.shape and (np.allclose(own, expected, atol=1e-6) if "delt" in name else np.array_equal(own, expected))
        print(f"{name}: {'ok' if is_same else f'{own} in place of {expected}'}")
        failed += not is_same
    return failed > 0


if __name__ == "__main__":
    sys.exit(main())
