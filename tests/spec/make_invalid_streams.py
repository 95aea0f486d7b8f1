#!/usr/bin/python3
"""Keeps tests/golden/invalid: for each place where the reference decoder rejects a stream (musts.py), a small stream that it and the program
reject there; and a few variants. TAG.dmsh, TAG.2.dmsh and so on break the rule TAG.

make_invalid_streams.py PROGRAM [TRIES [SEED]]: streams of another draft become streams of this one, as long as they are rejected as before.
Then TRIES changes of golden streams look for smaller ones, and for places that no stream reaches yet (4000: a few minutes). It fails where
there was a stream for a rule and is none any more; then run it with TRIES.
"""
import glob
import os
import random
import re
import subprocess
import sys
import tempfile

from reference_decoder_test import GOLDEN, decode, tag_of
from container import Broken
from invalid_by_hand import by_hand, generated, read, unfinished, variants
from musts import is_of_maps, place_of, places
from stream_changes import Parts, changed, of_this_draft

FOLDER = os.path.join(GOLDEN, "invalid")


def place_of_stream(data, known):
    """Where the reference decoder rejects it; None for a valid stream."""
    try:
        decode(data)
    except Broken as error:
        return place_of(error, known)
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
        self.program, self.streams, self.others, self.known = program, {}, {}, places()

    def take(self, data, variant=""):
        try:
            place = place_of_stream(data, self.known)
        except Exception as error:  # pylint: disable=broad-except
            place = None
            self.others[f"{type(error).__name__} {error}"[:60], ""] = data
        place = place and (*place, variant)
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


def seeds(program):
    """Golden streams, and small ones of coders and options that these lack."""
    made = [read(path) for path in sorted(glob.glob(os.path.join(GOLDEN, "*.dmsh")))]
    made += [generated(program, scene, vertices, options)
             for scene, vertices, options in (("cad", 60, "--keep-order --lossless"), ("cad", 80, "--profile zstd --keep-order"),
                                              ("fragments", 60, "--keep-order"), ("terrain", 60, "--lossless --keep-order"),
                                              ("torus", 100, "--lossless"), ("sphere", 60, "--geometry highpass --profile zstd"),
                                              ("rooms", 100, "--color-error 3"), ("sphere", 100, "--geometry highpass --bits 12"))]
    made += [smaller for seed in made for smaller in with_fewer_attributes(seed)]
    return [seed for seed in made if len(seed) < 2200] + list(unfinished())


def with_fewer_attributes(stream):
    """The stream without its attributes, and with one of them, or two that are coded one after the other."""
    parts = Parts(stream)
    others, listed = [chunk for chunk in parts.chunks if not chunk[1]], [chunk for chunk in parts.chunks if chunk[1]]
    for count in range(3):
        for i in range(len(listed) - count + 1 if count else 1):
            parts.chunks = others + listed[i:i + count]
            yield parts.stream()


def main():
    program, tries, seed = sys.argv[1:2] + [int(x) for x in (sys.argv[2:] + ["0", "1"][len(sys.argv) - 2:])]
    rng = random.Random(seed)
    os.makedirs(FOLDER, exist_ok=True)
    found, had = Found(program), glob.glob(os.path.join(FOLDER, "*.dmsh"))
    for data in by_hand(program):
        found.take(data)
    for variant, data in variants():
        found.take(data, variant)
    for path in had:
        found.take(of_this_draft(read(path)))
    sources = seeds(program) if tries else []
    for _ in range(tries):
        found.take(changed(rng.choice(sources), rng))
    rules = found.write()
    for (place, named), data in sorted(found.others.items(), key=str):
        print(f"{place}: the program names {named} for one of {len(data)} bytes")
    print(f"{sum(map(len, rules.values()))} streams for {len(rules)} rules: {' '.join(rules)}")
    lost = sorted({tag_of(path) for path in had} - set(rules))
    if lost:
        print("no stream breaks these rules any more: " + " ".join(lost))
    if lacking := sorted(p for p in found.known.keys() - {place[:3] for place in found.streams} if not is_of_maps(p)):
        print("places that no stream reaches: " + " ".join(f"{rule} {file}:{line}" for rule, file, line in lacking))
    return bool(lost)


if __name__ == "__main__":
    sys.exit(main())
