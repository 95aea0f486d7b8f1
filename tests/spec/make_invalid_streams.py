#!/usr/bin/python3
"""Keeps tests/golden/invalid: for each place where the reference decoder rejects a stream, a small stream that it and the program
reject there. TAG.dmsh, TAG.2.dmsh and so on break the rule TAG.

make_invalid_streams.py PROGRAM [TRIES [SEED]]: streams of another draft become streams of this one, as long as they are rejected as before.
Then TRIES changes of golden streams look for smaller ones, and for places that no stream reaches yet (4000: a few minutes). It fails where
there was a stream for a rule and is none any more; then run it with TRIES.
"""
import glob
import os
import random
import re
import struct
import subprocess
import sys
import tempfile
import traceback

from reference_decoder_test import GOLDEN, decode, tag_of
from container import Broken, DRAFT, KINDS, Reader
from stream_changes import Parts, changed, of_this_draft, sealed, varint

FOLDER = os.path.join(GOLDEN, "invalid")


def place_of(data):
    """The rule that the reference decoder names, with file and line; None for a valid stream."""
    try:
        decode(data)
    except Broken as error:
        frames = [f for f in traceback.extract_tb(error.__traceback__) if f.name != "must"]
        return error.tag, os.path.basename(frames[-1].filename), frames[-1].lineno
    return None


def rule_of_program(program, data):
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "stream.dmsh")
        with open(path, "wb") as file:
            file.write(data)
        run = subprocess.run([program, "decode", path, os.path.join(folder, "mesh.ply")], capture_output=True, text=True, check=False)
    named = re.search(r"[A-Z]{3,4}-\d+", run.stderr)
    return named.group(0) if run.returncode and named else None


class Found:
    """The smallest stream for each place; `others` counts pairs of rules that the decoders name for one stream."""
    def __init__(self, program):
        self.program, self.streams, self.others = program, {}, {}

    def take(self, data):
        try:
            place = place_of(data)
        except Exception as error:  # pylint: disable=broad-except
            place = None
            self.others[f"{type(error).__name__} {error}"[:60], ""] = data
        if not place or place in self.streams and len(self.streams[place]) <= len(data):
            return
        named = rule_of_program(self.program, data)
        if named == place[0]:
            self.streams[place] = data
        else:
            self.others[place, named] = data

    def write(self):
        names = {}
        for place, data in sorted(self.streams.items()):
            names.setdefault(place[0], []).append(data)
        for path in glob.glob(os.path.join(FOLDER, "*.dmsh")):
            os.remove(path)
        for rule, streams in names.items():
            for i, data in enumerate(streams, 1):
                with open(os.path.join(FOLDER, f"{rule}.{i}.dmsh" if i > 1 else f"{rule}.dmsh"), "wb") as file:
                    file.write(data)
        return names


def read(path):
    with open(path, "rb") as file:
        return file.read()


def golden(name):
    return read(glob.glob(os.path.join(GOLDEN, name + ".v1d*.dmsh"))[0])


def generated(program, scene, vertices, options):
    """The stream of a scene."""
    with tempfile.TemporaryDirectory() as folder:
        mesh, stream = os.path.join(folder, "mesh.glb"), os.path.join(folder, "stream.dmsh")
        subprocess.run([program, "generate", scene, mesh, "--vertices", str(vertices)], check=True, stdout=subprocess.DEVNULL)
        subprocess.run([program, "encode", mesh, stream] + options.split(), check=True, stdout=subprocess.DEVNULL)
        return read(stream)


def by_hand(program):
    """Streams for rules that changes by chance hardly break."""
    valid = golden("tetrahedron.default")
    yield from (b"XMS" + valid[3:], valid[:3] + b"\1" + valid[4:], valid[:3] + bytes([127 + DRAFT]) + valid[4:],
                valid[:-1] + bytes([valid[-1] ^ 1]), valid[:7])
    yield from headers_by_hand(Parts(valid), Parts(generated(program, "terrain", 30, "")))
    yield sealed(valid[:-4] + b"\0ABCD\0")
    yield sealed(Parts(valid).header + b"\x11\1" + varint(3000) + b"\0")  # 8 vertices and faces have no such chunk
    yield Parts(valid).replace("CONN", None, bytes(21))  # no tokens
    fragments = Parts(generated(program, "fragments", 60, "--geometry highpass"))
    yield fragments.replace("ANCH", None, b"\0\0")  # the first vertices are the anchors
    asset = Parts(golden("asset.lossless"))
    yield asset.replace("FGRP", None, b"\3" + bytes(2 * asset.fields.triangles) + b"\1" * asset.fields.triangles)
    yield Parts(golden("asset.lossless")).replace("ATTR", b"\x09", b"\x09\0")  # a sum of 0
    yield from attributes_by_hand()
    yield from faces_by_hand()
    yield Parts(generated(program, "cad", 30, "--geometry highpass")).replace("ATTR", b"\4", b"\4\1\0\0\x80\x3e")  # a rule


def attributes_by_hand():
    """Fields of attributes that are out of range."""
    for coding in (b"\1", b"\3"):
        yield Parts(golden("attributes.zstd")).replace("ATTR", coding, coding + b"\0")  # no bits
    base, large = varint(2**50), struct.pack("<f", 3e38)
    for fields in (b"\5\xff", b"\2" + large + base + b"\0"):  # an exponent, and a point beyond f32
        yield Parts(golden("asset.lossless")).replace("ATTR", b"\x08", b"\x08" + fields * 4)
    parts = Parts(golden("attributes.zstd"))
    rotations = next(payload for kind, _, payload in parts.chunks if KINDS[kind] == "ORDR")
    yield parts.replace("ORDR", None, rotations[:-1] + b"\3")


def faces_by_hand():
    """Plain CONN chunks, and a compact one that is too small for its faces."""
    def plain(tokens, references, far, glued):
        """With tokens of stream 1 alone."""
        counts = [0, len(tokens)] + [0] * 15 + [len(references), far, glued]
        return b"".join(map(varint, counts)) + tokens + references
    split = Parts(golden("tetrahedron.default"))
    yield split.replace("CONN", None, plain(b"\x80", b"\0", 0, 0) + bytes(3))  # far, but no far target
    r = Reader(next(payload for kind, _, payload in Parts(golden("grid.zstd")).chunks if KINDS[kind & 15] == "CONN"))
    counts = [r.varint() for _ in range(20)]
    head, tokens = b"".join(map(varint, counts[:19])), r.rest()[:sum(counts[:18])]
    for glued, gaps in ((1, b"\1\xff"), (20000, b"\0")):  # a gap beyond M, and more than M
        yield Parts(golden("grid.zstd")).replace("CONN", None, head + varint(glued) + tokens + b"\0" + gaps + b"\0")
    split.header = split.header[:5] + varint(43000) + split.header[6:]
    split.chunks = [(0x21, b"", b"\0"), (6, b"", b"")]
    yield split.stream()


def headers_by_hand(lattice, georeferenced):
    """Headers of a stream on a lattice and of one with an origin, changed."""
    def stream(header, chunks=b""):
        return sealed(lattice.header[:4] + header + chunks)
    flags, counts, rest = lattice.header[4:5], lattice.header[5:9], lattice.header[9:]
    step, nan = struct.pack("<f", lattice.fields.steps[0])[1:], struct.pack("<d", float("nan"))
    lattice.header = lattice.header.replace(step, b"\0\0\x7f")  # 2^127
    yield lattice.stream()
    yield stream(flags + b"\x80" * 10 + b"\1" + counts[1:] + rest)
    yield stream(flags + counts[:1] + varint(2**31 - 1) + b"\1\1" + rest)
    yield stream(flags + bytes(4) + rest, b"\6\1\0")  # no vertices, but a payload of positions
    after = rest.index(step) + len(step)
    yield stream(bytes([flags[0] | 32]) + counts + rest[:after] + nan * 3 + rest[after:])
    origin = struct.pack("<3d", *georeferenced.fields.origin)
    georeferenced.header = georeferenced.header.replace(origin, nan + origin[8:])
    yield georeferenced.stream()


def seeds(program):
    """Golden streams, and small ones of coders and options that these lack."""
    made = [read(path) for path in sorted(glob.glob(os.path.join(GOLDEN, "*.dmsh")))]
    made += [generated(program, scene, vertices, options)
             for scene, vertices, options in (("cad", 60, "--keep-order --lossless"), ("cad", 80, "--profile zstd --keep-order"),
                                              ("fragments", 60, "--keep-order"), ("terrain", 60, "--lossless --keep-order"),
                                              ("torus", 100, "--lossless"), ("sphere", 60, "--geometry highpass --profile zstd"),
                                              ("rooms", 100, "--color-error 3"), ("sphere", 100, "--geometry highpass --bits 12"))]
    return [seed for seed in made if len(seed) < 2200]


def main():
    program, tries, seed = sys.argv[1:2] + [int(x) for x in (sys.argv[2:] + ["0", "1"][len(sys.argv) - 2:])]
    rng = random.Random(seed)
    os.makedirs(FOLDER, exist_ok=True)
    found, had = Found(program), glob.glob(os.path.join(FOLDER, "*.dmsh"))
    for data in by_hand(program):
        found.take(data)
    for path in had:
        found.take(of_this_draft(read(path)))
    sources = seeds(program) if tries else []
    for _ in range(tries):
        found.take(changed(rng.choice(sources), rng))
    rules = found.write()
    for (place, named), data in sorted(found.others.items(), key=str) if tries else []:
        print(f"{place}: the program names {named} for one of {len(data)} bytes")
    print(f"{sum(map(len, rules.values()))} streams for {len(rules)} rules: {' '.join(rules)}")
    lost = sorted({tag_of(path) for path in had} - set(rules))
    if lost:
        print("no stream breaks these rules any more: " + " ".join(lost))
    return bool(lost)


if __name__ == "__main__":
    sys.exit(main())
