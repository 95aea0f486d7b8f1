#!/usr/bin/python3
"""Keeps tests/golden/invalid_maps: for each place where the reference decoder rejects a part or a message of a map (musts.py), a small file that
does: TAG.map, TAG.2.map and so on break the rule TAG. tests/map/spec/invalid_test.cpp reads them as well.

A file has one or more blobs, each a varint and as many bytes: messages; or a map's message, and a key [MAP-12] with the octets of its part.

make_invalid_maps.py PROGRAM: makes the files anew, of this draft."""
import glob
import os
import random
import struct
import subprocess
import sys
import tempfile

import xxhash

from reference_decoder_test import GOLDEN
from container import Broken, DRAFT, Reader, VOXELS
from messages import MAP_1_fields, MAP_25_whole, Pose
from musts import is_of_maps, place_of, places
from other_decisions import ChanceCoder
from parts import Map, PartHeader
from patches import MAP_3_key
from reference_examples_test import line
from stream_changes import sealed, varint

FOLDER = os.path.join(GOLDEN, "invalid_maps")
TRIES = 400


def read(data):
    """Decodes the blobs of a file."""
    r, blobs = Reader(data), []
    while r.at < len(data):
        blobs.append(r.bytes(r.varint()))
    kind = blobs[0][4:5]
    if kind == b"\12":
        Pose(blobs[0])
    elif kind == b"\13":
        MAP_25_whole(blobs)
    else:
        whole, r = Map(blobs[0]), Reader(blobs[1] if len(blobs) > 1 else b"\0" * 4)
        whole.MAP_7_part(MAP_3_key(r), r.rest())


def blobs(*parts):
    return b"".join(varint(len(part)) + part for part in parts)


def message(kind, fields):
    return sealed(b"DMM" + bytes([128 + DRAFT, kind]) + fields)


class Part:
    """Octets of a part of a map, `before` its border, the border, and the chunks."""
    def __init__(self, whole, key, octets):
        self.whole, self.octets, self.hash, self.place = whole, octets, xxhash.xxh3_64_intdigest(whole), key
        self.key = bytes([key[0]]) + b"".join(varint(2 * x if x >= 0 else -2 * x - 1) for x in key[1:])
        r = Reader(octets[:-4])
        self.header = PartHeader(r, Map(whole).corner(key), Map(whole).grid)
        self.before, self.border, self.chunks = octets[:r.at], r.bytes(r.varint()), r.rest()

    def sealed(self, body, before=b""):
        seed = xxhash.xxh3_64_intdigest(struct.pack("<QBiii", self.hash, *self.place))
        return body + struct.pack("<I", xxhash.xxh3_64_intdigest(before + body, seed=seed) % 2**32)

    def with_border(self, border):
        return self.sealed(self.before + varint(len(border)) + border + self.chunks)

    def patched(self, plan, inserted, base=None):
        base = base or self.octets
        body = self.sealed(varint(len(plan)) + plan + inserted, struct.pack("<Q", xxhash.xxh3_64_intdigest(base)))
        return b"\4" + self.key + varint(len(base)) + base + body

    def file(self, octets):
        return blobs(self.whole, self.key + octets)


def parts_of(program, positions, faces, options):
    """Parts of a map of a coloured mesh, made by the program."""
    with tempfile.TemporaryDirectory() as work:
        path, folder = os.path.join(work, "mesh.ply"), os.path.join(work, "map")
        with open(path, "w", encoding="utf-8") as file:
            file.write(f"ply\nformat ascii 1.0\nelement vertex {len(positions)}\n" + "".join(f"property float {x}\n" for x in "xyz") +
                       "".join(f"property uchar {x}\n" for x in ("red", "green", "blue")) +
                       f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n" +
                       "".join("%g %g %g %d 90 50\n" % (*p, i % 256) for i, p in enumerate(positions)) + "".join("3 %d %d %d\n" % f for f in faces))
        subprocess.run([program, "map", "split", path, folder] + options.split(), check=True, stdout=subprocess.DEVNULL)
        with open(os.path.join(folder, "map.dmm"), "rb") as file:
            r = MAP_1_fields(file.read(), 2)
        whole = r.bytes(r.varint())
        for name in sorted(glob.glob(os.path.join(folder, "parts", "*.part"))):
            with open(name, "rb") as file:
                yield Part(whole, tuple(int(x) for x in os.path.basename(name).split("_")[:4]), file.read())


def by_chance(payload, file_of, first, rng):
    """A file with decisions of chance in a compact stream, from number `first` on."""
    coder = ChanceCoder(payload, first, rng)
    coder.run(file_of(payload), read)
    return file_of(coder.encoded(rng.random() < 0.5))


def of_messages():
    whole, pose, pieces = line("map.md", "message", bytes), line("map.md", "pose", bytes), [line("map.md", f"fragment-{i}", bytes) for i in range(3)]
    yield blobs(whole[:4] + b"\2" + whole[5:])
    yield blobs(whole[:-1] + bytes([whole[-1] ^ 1]))
    yield blobs(message(1, whole[5:-6] + b"\1" + b"\0\1\1\3\1\3red" + b"\0"))
    yield blobs(message(1, whole[5:-7] + b"\2\0\0"))
    for origin, edge in ((0.0, 0.0), (float("inf"), 1.0)):
        yield blobs(message(1, whole[5:-7] + b"\1" + struct.pack("<6d", *[origin] * 3, *[edge] * 3) + b"\0\0"))
    for at, value in ((23, 0.7), (55, float("inf"))):
        yield blobs(message(10, pose[5:at] + struct.pack("<d", value) + pose[at + 8:-4]))
    yield blobs(message(11, pieces[0][5:13] + varint(8) + pieces[0][14:-4]))
    yield blobs(message(11, pieces[0][5:13] + varint(300000) + pieces[0][14:-4]))
    yield blobs(*pieces[:2], message(11, pieces[2][5:-5] + bytes([pieces[2][-5] ^ 1])))


def of_parts(square, strip, rng):
    """`square`: a part with two faces; `strip`: one with a border."""
    yield square.file(square.octets[:-1] + bytes([square.octets[-1] ^ 1]))
    yield square.file(square.sealed(b"\1\0"))
    yield square.file(square.sealed(bytes([square.before[0] | 2]) + square.octets[1:-4]))
    yield square.file(square.sealed(square.octets[:-4] + b"\x27\0"))
    yield square.file(square.sealed(square.octets[:-4] + b"\x28\0"))
    for _ in range(TRIES):
        yield by_chance(strip.border, lambda border: strip.file(strip.with_border(border)), rng.randrange(30), rng)


def of_patches(square, rng):
    plan, octets = line("map.md", "plan", bytes), square.octets
    yield square.file(b"\4\31\0\0\0")
    yield square.file(b"\4\0" + varint(2**32) + b"\0\0")
    for _ in range(17):
        octets = b"\4" + square.key + varint(len(octets)) + octets
    yield square.file(octets)
    yield square.file(square.patched(plan, square.patched(plan, b"")[:-4]))
    yield square.file(square.patched(b"", b""))
    groups = line("fgrp.md", "compact", bytes)
    yield square.file(square.patched(plan, b"", square.sealed(square.octets[:-4] + b"\x23" + varint(len(groups)) + groups)))
    yield square.file(square.patched(plan, b"")[:-1] + b"\0")
    for i in range(4 * TRIES):
        yield by_chance(plan, lambda plan, inserted=square.octets[:-4] * (i % 2): square.file(square.patched(plan, inserted)), rng.randrange(10), rng)


def beyond_bricks(far):
    """Vertices of `far` are in more bricks of the grid of a part beside it than these may be."""
    r = Reader(far.before[1:])
    for _ in range(4):
        r.varint()
    counts, lattice = bytes([4, 5, 0, 1]), r.rest()
    grid = line("map.md", "grid", bytes)
    inserted = bytes([far.before[0] & 0x3f | VOXELS << 6]) + counts + lattice + b"\1\0\x29" + varint(len(grid)) + grid + b"\x27\0"
    yield far.file(far.patched(b"", inserted))


def candidates(program):
    rng = random.Random(1)
    square, = parts_of(program, [(0, 0, 0), (1, 0, 0), (0, 1, 0.5), (1, 1, 0)], [(0, 1, 2), (2, 1, 3)], "--part-edge 8 --max-error 0.1")
    strip = [(i // 2, i % 2, i % 3) for i in range(12)]
    strip = next(parts_of(program, strip, [(i, i + 1, i + 2) for i in range(10)], "--part-edge 2 --part-triangles 4 --max-error 0.1 --color-error 3"))
    far = [(i * i * 37 % 9973, i * i * 91 % 9949, i * 53 % 997) for i in range(201)]
    far, = parts_of(program, far, [(i, i + 1, i + 2) for i in range(0, 201, 3)], "--part-edge 20000 --max-error 1 --geometry predictive")
    yield from of_messages()
    yield from of_parts(square, strip, rng)
    yield from of_patches(square, rng)
    yield from beyond_bricks(far)


def main():
    found, known, others = {}, places(), {}
    for data in candidates(sys.argv[1]):
        try:
            read(data)
            continue
        except Broken as error:
            place = place_of(error, known)
        except Exception as error:  # pylint: disable=broad-except
            others[f"{type(error).__name__} {error}"[:60]] = data
            continue
        if is_of_maps(place) and (place not in found or len(data) < len(found[place])):
            found[place] = data
    os.makedirs(FOLDER, exist_ok=True)
    for path in glob.glob(os.path.join(FOLDER, "*.map")):
        os.remove(path)
    names = {}
    for (rule, *_), data in sorted(found.items()):
        names[rule] = names.get(rule, 0) + 1
        with open(os.path.join(FOLDER, f"{rule}.{names[rule]}.map" if names[rule] > 1 else f"{rule}.map"), "wb") as file:
            file.write(data)
    lacking = sorted(place for place in known.keys() - found.keys() if is_of_maps(place))
    print(f"{len(found)} files for {len(names)} rules: {' '.join(names)}")
    print("\n".join([f"no file breaks {rule} at {file}:{at}" for rule, file, at in lacking] + [f"the decoder fails: {text}" for text in others]))
    return bool(lacking or others)


if __name__ == "__main__":
    sys.exit(main())
