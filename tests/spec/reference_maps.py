#!/usr/bin/python3
"""Decodes the parts of maps, made by the program of scenes and of meshes of the corpus, with the reference decoder, and compares their faces
with those of the program's joined mesh; and parts with patches. reference_maps.py PROGRAM PATCHED_PARTS [CORPUS]"""
import glob
import os
import subprocess
import sys
import tempfile

import numpy as np

from reference_decoder_streams import read_positions
from parts import Map
from patches import MAP_3_key
from ply import usual_first
from container import Reader

MAPS = [("rooms", 4000, "--part-edge 2 --max-error 0.02"), ("rooms", 3000, "--part-edge 3 --geometry highpass"),
        ("rooms", 3000, "--part-edge 2 --geometry predictive --max-error 0.001 --part-triangles 400"),
        ("terrain", 3000, "--part-edge 20"), ("cad", 2000, "--part-edge 20 --lfe 0.1%"), ("fragments", 2000, "--part-edge 1"),
        ("terrain", 3000, "--part-edge 30 --color-error 4 --geometry predictive"), ("rooms", 4000, "--part-edge 2 --levels 2")]
FILES = [("formats/Duck.glb", "--part-edge 40"), ("gltf/Fox.glb", "--part-edge 50 --geometry predictive"), ("models/fandisk.ply", "--part-edge 1")]


def decoded_parts(folder):
    """Of every part of a map's folder its key, its mesh, with the LFE of its entry, and the map, by key."""
    with open(os.path.join(folder, "map.dmm"), "rb") as file:
        r = Reader(file.read()[5:-4])  # [MAP-10]
    described = Map(r.bytes(r.varint()))
    r.varint(), r.varint()
    lfe = dict(entries(r, len(described.attributes)))
    for path in sorted(glob.glob(os.path.join(folder, "parts", "*.part")), key=key_of):
        with open(path, "rb") as file:
            mesh = described.MAP_7_part(key_of(path), file.read())
        mesh.header.lfe = lfe[key_of(path)]
        yield key_of(path), mesh, described


def is_coarser(key, keys):
    """Whether a part is a coarser copy of others [MAP-3]."""
    return any(other[0] < key[0] and [x >> (key[0] - other[0]) for x in other[1:]] == list(key[1:]) for other in keys)


def key_of(path):
    return tuple(int(x) for x in os.path.basename(path).split("_")[:4])


def corners_of(positions, others, faces):
    """Positions and the bytes of attributes at every corner of every face."""
    at = np.array(faces).reshape(-1)
    return positions[at], [np.frombuffer(x, dtype="u1").reshape(len(positions), -1)[at] for x in others]


def entries(r, attributes):
    """[MAP-13] Of every part of a manifest [MAP-10] its key and its LFE."""
    while r.at < len(r.data):
        part, _, _ = MAP_3_key(r), r.varint(), r.varint()
        for _ in range(r.varint()):  # links [MAP-12]
            kind = r.u8()
            if kind & 31 == 27:
                MAP_3_key(r)
            r.number("I")
            if kind & 64:
                r.varint()
        r.varint()
        r.bytes(8)
        _, _, figures = r.varint(), r.varint(), [r.number("f") for _ in range(9 + attributes)]
        yield part, figures[7]


def compare(folder, joined):
    """How many parts there are, and why the first one that differs does; an empty text if none does. The joined mesh has
    no coarser parts, which are decoded only."""
    positions, others, faces = read_positions(joined)
    rows = np.frombuffer(faces, dtype=[("count", "u1"), ("of", "<i4", 3)])["of"]
    positions, others = corners_of(positions, others[1:], rows)
    first, count = 0, 0
    parts = list(decoded_parts(folder))
    keys = [key for key, _, _ in parts]
    for key, mesh, described in parts:
        if is_coarser(key, keys):
            count += 1
            continue
        columns = [a.values[:, i].tobytes() for a, _ in usual_first(mesh.attributes) for i in range(a.k)]
        own, own_others = corners_of(mesh.positions + np.array(described.origin), columns, mesh.faces)
        its = positions[first:first + len(own)].astype(np.float64)
        if len(its) != len(own):
            return count, f"part {key}: {len(own) // 3} faces"
        far = np.sqrt(((own - its)**2).sum(axis=1).mean())
        if not np.array_equal(own, its) and (mesh.exact or far > 0.01 * mesh.header.lfe):
            return count, f"part {key}: positions are {far / mesh.header.lfe} of the LFE away"
        if len(own_others) != len(others) or not all(
                np.array_equal(a, b[first:first + len(own)]) for a, b in zip(own_others, others)):
            return count, f"part {key}: attributes differ"
        first, count = first + len(own), count + 1
    return count, "" if first == len(positions) else f"{first // 3} of {len(positions) // 3} faces"


def patched_parts(program, folder, voxels):
    """How many parts of a map that changed have patches, and which part differs, or an empty text."""
    os.mkdir(folder)
    subprocess.run([program, folder, voxels], check=True)
    with open(os.path.join(folder, "map"), "rb") as file:
        described = Map(file.read())
    patched = 0
    for path in sorted(glob.glob(os.path.join(folder, "*.mesh"))):
        with open(path, "rb") as file:
            vertices, triangles = (int.from_bytes(file.read(4), "little") for _ in range(2))
            positions, faces = np.frombuffer(file.read(12 * vertices), dtype="<f4"), np.frombuffer(file.read(12 * triangles), dtype="<u4")
            colours = file.read()
        with open(path[:-5], "rb") as file:
            octets = file.read()
        patched += octets[0] == 4
        mesh = described.MAP_7_part(key_of(path[:-5]), octets)
        is_alike = np.array_equal(mesh.positions.reshape(-1), positions) and np.array_equal(np.array(mesh.faces).reshape(-1), faces)
        if not is_alike or b"".join(a.values.tobytes() for a in mesh.attributes) != colours:
            return patched, f"part {path} differs"
    return patched, "" if patched else "no part has a patch"


def main():
    program, patches, corpus = sys.argv[1], sys.argv[2], sys.argv[3:4]
    failed = parts = 0
    with tempfile.TemporaryDirectory() as work:
        for voxels in ("0.05", "0.01"):  # 10 levels, and 50, whose lowest bits are raw
            count, wrong = patched_parts(patches, os.path.join(work, voxels), voxels)
            failed += bool(wrong)
            print(f"drive, {voxels} voxel: {wrong or f'{count} parts with patches ok'}", flush=True)
        made = []
        for scene, vertices, options in MAPS:
            made.append((os.path.join(work, f"{scene}{len(made)}" + (".glb" if scene == "cad" else ".ply")), options))
            subprocess.run([program, "generate", scene, made[-1][0], "--vertices", str(vertices)], check=True, stdout=subprocess.DEVNULL)
        for i, (mesh, options) in enumerate(made + [(os.path.join(*corpus, name), options) for name, options in FILES * len(corpus)]):
            folder, joined = os.path.join(work, f"map{i}"), os.path.join(work, "joined.ply")
            subprocess.run([program, "map", "split", mesh, folder] + options.split(), check=True, stdout=subprocess.DEVNULL)
            subprocess.run([program, "map", "join", folder, joined], check=True, stdout=subprocess.DEVNULL)
            count, wrong = compare(folder, joined)
            parts += count
            failed += bool(wrong)
            print(f"{os.path.basename(mesh)} {options}: {wrong or f'{count} parts ok'}", flush=True)
    print(f"{parts} parts of maps decode alike, {failed} maps do not")
    return failed > 0


if __name__ == "__main__":
    sys.exit(main())
