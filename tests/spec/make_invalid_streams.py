#!/usr/bin/python3
"""Makes tests/golden/invalid/TAG.dmsh: for each rule that a stream can break, a small stream that breaks it.

It changes bytes of golden streams, mends the checksum, and keeps the smallest stream for each rule that both the reference decoder
and the program name. make_invalid_streams.py PROGRAM [TRIES]
"""
import glob
import os
import random
import re
import struct
import subprocess
import sys

import xxhash

from reference_decoder_test import GOLDEN, decode
from attr import Attribute
from container import Broken, DIR_2_chunk, Header, Reader, ZSTD


def sealed(data):
    return data + struct.pack("<I", xxhash.xxh3_64_intdigest(data) % 2**32)


def broken_rule(data):
    try:
        decode(data)
    except Broken as error:
        return error.tag
    return None


def rule_of_program(program, data, folder):
    path = os.path.join(folder, "tried.dmsh")
    with open(path, "wb") as file:
        file.write(data)
    run = subprocess.run([program, "decode", path, os.path.join(folder, "tried.ply")], capture_output=True, text=True, check=False)
    os.remove(path)
    named = re.search(r"[A-Z]{3,4}-\d+", run.stderr)
    return named.group(0) if run.returncode and named else None


def varint(value):
    return bytes([value]) if value < 128 else bytes([value & 127 | 128]) + varint(value >> 7)


class Parts:
    """The header of a stream and its chunks as (kind, descriptor, payload), zstd ones as raw."""
    def __init__(self, data):
        r = Reader(data[:-4])
        r.at = 4
        header, self.chunks, spans = Header(r), [], []
        self.header = data[:r.at]

        def read_descriptor(r):
            start = r.at
            descriptor = Attribute(r)
            spans.append(data[start:r.at])
            return descriptor
        while r.at < len(r.data):
            kind = data[r.at]
            payload = DIR_2_chunk(r, header, read_descriptor).data
            self.chunks.append((kind & 15 if kind >> 4 == ZSTD else kind, spans.pop() if spans else b"", payload))

    def stream(self):
        return sealed(self.header + b"".join(bytes([kind]) + varint(len(payload)) + descriptor + payload
                                             for kind, descriptor, payload in self.chunks))

    def change(self, rng):
        """Changes the header, or one chunk."""
        if rng.random() < 0.2:
            self.header = self.header[:4] + with_changes(self.header[4:], rng)
            return
        i = rng.randrange(len(self.chunks))
        kind, descriptor, payload = self.chunks[i]
        how = rng.random()
        if how < 0.03:
            self.chunks.append(self.chunks[i])
        elif how < 0.06:
            del self.chunks[i]
        elif how < 0.1:
            self.chunks[i] = kind ^ rng.choice((16, 32, 48)), descriptor, payload
        elif how < 0.2 and descriptor:
            self.chunks[i] = kind, with_changes(descriptor, rng), payload
        else:
            first = rng.choice((1, 2, 8, len(payload)))
            self.chunks[i] = kind, descriptor, with_changes(payload[:first], rng) + payload[first:]


def with_changes(data, rng):
    """A few bytes changed, put in or left out."""
    data = bytearray(data)
    for _ in range(rng.choice((1, 1, 1, 2, 3))):
        at, how = rng.randrange(len(data) + 1), rng.random()
        if how < 0.8 and at < len(data):
            data[at] = rng.choice((0, 1, 255, 128, data[at] ^ 1, data[at] + 1 & 255, data[at] - 1 & 255, rng.randrange(256)))
        elif how < 0.9:
            del data[at:at + rng.choice((1, 1, 4))]
        else:
            data[at:at] = rng.choice((b"\0", b"\xff", b"\xff\xff\xff\xff"))
    return bytes(data)


def more_seeds(program, folder):
    """Small streams of coders and options that the golden ones lack."""
    made = []
    for scene, vertices, options in (("cad", 60, "--keep-order --lossless"), ("cad", 80, "--profile zstd --keep-order"),
                                     ("fragments", 60, "--keep-order"), ("terrain", 60, "--lossless --keep-order"),
                                     ("torus", 100, "--lossless"), ("sphere", 60, "--geometry highpass --profile zstd"),
                                     ("rooms", 100, "--color-error 3"), ("sphere", 100, "--geometry highpass --bits 12")):
        mesh, stream = os.path.join(folder, "seed.glb"), os.path.join(folder, "seed.dmsh")
        subprocess.run([program, "generate", scene, mesh, "--vertices", str(vertices)], check=True, stdout=subprocess.DEVNULL)
        subprocess.run([program, "encode", mesh, stream] + options.split(), check=True, stdout=subprocess.DEVNULL)
        with open(stream, "rb") as file:
            made.append(file.read())
        os.remove(mesh)
        os.remove(stream)
    return made


def changed(data, rng):
    if rng.random() < 0.1:
        return sealed(data[:4] + with_changes(data[4:-4], rng))
    parts = Parts(data)
    parts.change(rng)
    return parts.stream()


def main():
    program, tries, rng, found = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 4000, random.Random(1), {}
    folder = os.path.join(GOLDEN, "invalid")
    os.makedirs(folder, exist_ok=True)
    seeds = []
    for path in sorted(glob.glob(os.path.join(GOLDEN, "*.dmsh"))):
        with open(path, "rb") as file:
            seeds.append(file.read())
    seeds += more_seeds(program, folder)
    seeds = [seed for seed in seeds if len(seed) < 4000]
    first = seeds[0]
    tried = [b"XMS" + first[3:], first[:3] + b"\1" + first[4:], first[:3] + b"\x81" + first[4:], first[:-1] + bytes([first[-1] ^ 1])]
    for i in range(tries):
        data = tried[i] if i < len(tried) else changed(rng.choice(seeds), rng)
        rule = broken_rule(data)
        if rule and (rule not in found or len(data) < len(found[rule])) and rule_of_program(program, data, folder) == rule:
            found[rule] = data
    for path in glob.glob(os.path.join(folder, "*.dmsh")):
        os.remove(path)
    for rule, data in sorted(found.items()):
        with open(os.path.join(folder, rule + ".dmsh"), "wb") as file:
            file.write(data)
    print(f"{len(found)} rules: {' '.join(sorted(found))}")


if __name__ == "__main__":
    main()
