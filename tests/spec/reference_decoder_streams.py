#!/usr/bin/python3
"""Makes streams with the program, of scenes, meshes and packed assets, over its options, and compares what the reference decoder and the
program decode.

reference_decoder_streams.py PROGRAM CORPUS [COUNT [FIRST]], CORPUS being "none" for scenes alone; 220 tries of meshes make more than 200 streams. Takes about five minutes.
"""
import itertools
import json
import os
import struct
import subprocess
import sys
import tempfile

import numpy as np

from reference_decoder_test import decode, wrong_positions
import ply

SCENES = [(scene, count, seed) for seed, count in ((1, 400), (2, 900), (3, 2500))
          for scene in ("rooms", "terrain", "sphere", "torus", "cad", "fragments")]
FILES = ["formats/suzanne.obj", "gltf/ClearCoatTest.glb", "formats/fuze.obj", "gltf/cakeBirthday.glb", "models/teapot.ply",
         "formats/Duck.glb", "gltf/Fox.glb", "formats/texturedknot_wedge_uv.ply", "formats/inspired_quads.off",
         "paper/horse_4243.ply", "models/chair_nonmanifold.ply", "gltf/AnimatedMorphSphere.glb", "models/fandisk.ply",
         "formats/suzanne_ascii_uv_normals.ply", "formats/screwdriver_big_endian.ply"]
OPTIONS = ["", "--lossless", "--geometry highpass", "--geometry predictive", "--profile zstd", "--geometry highpass --bits 6",
           "--lossless --keep-order --keep-unreferenced", "--geometry predictive --bits 9 --color-error 4 --normal-error 2",
           "--effort 0", "--geometry highpass --profile zstd --keep-order", "--max-error 0.5% --color-error 8 --uv-error 1/512",
           "--effort 2 --max-error 0.1%", "--vde 0.05%", "--lfe 0.1% --normal-error 0.1 --tangent-error 1",
           "--geometry predictive --profile zstd --color-error 2", "--geometry highpass --bits 10 --anchors 40 --anchor-bits 16",
           "--geometry predictive --max-error 0.002% --normal-error 0 --uv-error 0", "--target-bytes 4000",
           "--color-rms 3", "--geometry highpass --bits 9 --color-psnr 44",
           "--geometry highpass --step 0.01 --anchor-density 3 --keep-order", "--lossless --profile zstd",
           "--geometry predictive --bits 5 --keep-order --weight-error 1/64 --normal-error 8", "--geometry highpass --bits 4 --anchors 1000",
           "--geometry predictive --effort 0 --uv-error 1/100 --normal-error 0.01", "--lossless --effort 0", "--geometry predictive --vde 0.2%"]

ASSETS = [("gltf/Fox.glb", "--lossless"), ("gltf/ClearCoatTest.glb", ""), ("gltf/cakeBirthday.glb", "--color-error 4"),
          ("gltf/AnimatedMorphSphere.glb", "--normal-error 2"), ("gltf/MorphStressTest.glb", ""), ("gltf/2CylinderEngine.glb", ""),
          ("formats/Duck.glb", "--effort 0 --uv-error 1/512"), ("formats/boat.glb", "--lossless")]


def read_positions(path):
    """The positions of a PLY file of the program, and the other bytes of vertices, and those of faces."""
    with open(path, "rb") as file:
        head, _, body = file.read().partition(b"end_header\n")
    sizes = {"char": "i1", "uchar": "u1", "short": "<i2", "ushort": "<u2", "int": "<i4", "uint": "<u4", "float": "<f4", "double": "<f8"}
    lines = [line.split() for line in head.decode().split("\n")]
    count = next(int(line[2]) for line in lines if line[:2] == ["element", "vertex"])
    fields = [(line[2], sizes[line[1]]) for line in lines if line[:1] == ["property"] and line[1] != "list"]
    rows = np.frombuffer(body, dtype=[(f"c{i}", kind) for i, (_, kind) in enumerate(fields)], count=count)
    columns = [rows[f"c{i}"] for i in range(len(fields))]  # names may come twice
    return np.stack(columns[:3], axis=1).reshape(-1, 3), [fields] + [x.tobytes() for x in columns[3:]], body[rows.nbytes:]


def compare(program, stream, work):
    """Why the decoders differ; an empty text if they do not."""
    own, its = os.path.join(work, "own.ply"), os.path.join(work, "its.ply")
    subprocess.run([program, "decode", stream, its], check=True, stdout=subprocess.DEVNULL)
    with open(stream, "rb") as file:
        mesh = decode(file.read())
    ply.write(own, mesh)
    (a, rows_a, faces_a), (b, rows_b, faces_b) = read_positions(own), read_positions(its)
    if mesh.exact:
        wrong = "" if a.tobytes() == b.tobytes() else "positions differ"
    else:  # with an origin the file has doubles, and the sum is rounded to them
        wrong = wrong_positions(mesh, b - mesh.header.origin, np.spacing(abs(b)) if any(mesh.header.origin) else 0)
    if [kind for _, kind in rows_a[0]] != [kind for _, kind in rows_b[0]]:  # the program makes names that come twice differ
        return wrong + f" properties {rows_a[0]} in place of {rows_b[0]}"
    wrong += "".join(f" {name} differs" for (name, _), x, y in zip(rows_a[0][3:], rows_a[1:], rows_b[1:]) if x != y)
    return (wrong + (" faces differ" if faces_a != faces_b else "")).strip()


def made_by(program, words):
    """What the program says where it fails, else nothing."""
    run = subprocess.run([program] + words, capture_output=True, text=True, check=False)
    return run.stderr.strip() if run.returncode else ""


def streams_of_asset(path):
    """The streams in a packed .glb."""
    with open(path, "rb") as file:
        data = file.read()
    size, = struct.unpack("<I", data[12:16])
    asset, binary = json.loads(data[20:20 + size]), data[28 + size:]
    for primitive in (p for mesh in asset["meshes"] for p in mesh["primitives"]):
        packed = primitive.get("extensions", {}).get("DELTAMESH_mesh_compression")
        if packed and "bufferView" in packed:
            view = asset["bufferViews"][packed["bufferView"]]
            yield binary[view.get("byteOffset", 0):][:view["byteLength"]]


def streams_of_meshes(program, corpus, work, count, first):
    """Pairs of a name and a stream's path."""
    meshes, stream = [], os.path.join(work, "stream.dmsh")
    for scene, vertices, seed in SCENES:
        meshes.append(os.path.join(work, f"{scene}_{seed}.glb" if scene == "cad" else f"{scene}_{seed}.ply"))
        made_by(program, ["generate", scene, meshes[-1], "--vertices", str(vertices), "--seed", str(seed)])
    meshes += [os.path.join(corpus, name) for name in FILES if corpus != "none"]
    for i in range(first, first + count):
        mesh, options = meshes[i % len(meshes)], OPTIONS[(i // len(meshes) + i) % len(OPTIONS)]
        fault = made_by(program, ["encode", mesh, stream] + options.split())
        if fault:
            print(f"{i} {os.path.basename(mesh)} {options}: not made: {fault}")
        else:
            yield f"{i} {os.path.basename(mesh)} {options}", stream


def streams_of_assets(program, corpus, work):
    for asset, options in ASSETS if corpus != "none" else []:
        packed = os.path.join(work, "packed.glb")
        fault = made_by(program, ["gltf", "pack", os.path.join(corpus, asset), packed] + options.split())
        if fault:
            print(f"{asset} {options}: not made: {fault}")
            continue
        for i, data in enumerate(streams_of_asset(packed)):
            if len(data) < 30000:
                stream = os.path.join(work, "stream.dmsh")
                with open(stream, "wb") as file:
                    file.write(data)
                yield f"{asset} {options}, stream {i}", stream


def main():
    program, corpus = sys.argv[1:3]
    if corpus != "none" and not os.path.isdir(corpus):
        sys.exit(f"{corpus}: no such folder")
    count, first = (int(x) for x in (sys.argv[3:] + ["220", "0"][len(sys.argv) - 3:]))
    alike = made = 0
    with tempfile.TemporaryDirectory() as work:
        for name, stream in itertools.chain(streams_of_meshes(program, corpus, work, count, first), streams_of_assets(program, corpus, work)):
            made += 1
            try:
                wrong = compare(program, stream, work)
            except Exception as error:  # any failure is one of this stream
                wrong = f"{type(error).__name__} {error}"
            alike += not wrong
            print(f"{name}: {wrong or 'ok'}", flush=True)
    print(f"{alike} of {made} streams decode alike")
    return alike < made


if __name__ == "__main__":
    sys.exit(main())
