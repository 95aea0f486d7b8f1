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


def plain(data):
    """The same stream with raw chunks in place of zstd ones, so that changes reach what is in them."""
    r = Reader(data[:-4])
    r.at = 4
    header = Header(r)
    body = data[:r.at]
    while r.at < len(r.data):
        start, spans = r.at, []

        def read_descriptor(r):
            spans.append(r.at)
            descriptor = Attribute(r)
            spans.append(r.at)
            return descriptor
        chunk = DIR_2_chunk(r, header, read_descriptor)
        descriptor = data[spans[0]:spans[1]] if spans else b""
        if data[start] >> 4 != ZSTD:
            body += data[start:r.at]
        else:
            body += bytes([data[start] & 15]) + varint(len(chunk.data)) + descriptor + chunk.data
    return sealed(body)


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
    """A stream with a few bytes changed, inserted, doubled or left out; mostly near the start, where the header is."""
    body = bytearray(data[:-4])
    for _ in range(rng.choice((1, 1, 1, 2, 3))):
        at = rng.randrange(3, min(len(body), rng.choice((12, 60, 120, len(body)))))
        how = rng.random()
        if how < 0.7:
            body[at] = rng.choice((0, 1, 255, 128, body[at] ^ 1, body[at] + 1 & 255, body[at] - 1 & 255, rng.randrange(256)))
        elif how < 0.8:
            del body[at:at + rng.choice((1, 1, 4))]
        elif how < 0.9:
            body[at:at] = rng.choice((b"\0", b"\xff", bytes(body[at:at + 4])))
        else:
            del body[max(at, 4):]
    return sealed(bytes(body))


def main():
    program, tries, rng, found = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 4000, random.Random(1), {}
    folder = os.path.join(GOLDEN, "invalid")
    os.makedirs(folder, exist_ok=True)
    seeds = []
    for path in sorted(glob.glob(os.path.join(GOLDEN, "*.dmsh"))):
        with open(path, "rb") as file:
            seeds.append(file.read())
    seeds = [plain(seed) for seed in seeds + more_seeds(program, folder)]
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
