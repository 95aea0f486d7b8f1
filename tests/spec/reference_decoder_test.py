#!/usr/bin/python3
"""Decodes every golden stream with the reference decoder and compares with the positions, faces and digests beside it. Streams TAG.dmsh,
TAG.2.dmsh and so on of the folder `invalid` (make_invalid_streams.py) break the rule TAG."""
import glob
import json
import os
import subprocess
import sys

import numpy as np

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
GOLDEN = os.path.join(ROOT, "tests", "golden")
DECODER = os.path.join(ROOT, "spec", "decoder")
sys.path.insert(0, DECODER)
from container import Broken  # noqa: E402
from mesh import decode  # noqa: E402


def read_off(path):
    with open(path, encoding="ascii") as file:
        words = file.read().split()
    n, m = int(words[1]), int(words[2])
    positions = np.array(words[4:4 + 3 * n], dtype=np.float64).astype(np.float32).reshape(n, 3)
    return positions, np.array(words[4 + 3 * n:4 + 3 * n + 4 * m], dtype=np.int64).reshape(m, 4)[:, 1:]


def far_off(positions, expected, header, rounding):
    """What of the LFE the decoded positions are away from the expected ones, by more than these were rounded on each axis."""
    distances = (np.maximum(abs(positions.astype(np.float64) - expected) - rounding, 0)**2).sum(axis=1)
    rms = float(np.sqrt(distances.mean())) if len(distances) else 0.0
    return rms / header.lfe if header.lfe else 0.0 if rms == 0 else float("inf")


def wrong_positions(mesh, expected, rounding=0):
    """Why the positions are not as the specification says; an empty text if they are. `rounding`: of `expected`, by coordinate."""
    if mesh.exact:
        count = int(np.count_nonzero(np.any(mesh.positions.view("u4") != expected.view("u4"), axis=1)))
        return f"{count} positions differ" if count else ""
    share, most = far_off(mesh.positions, expected, mesh.header, rounding), 0.01
    return f"positions are {share:.4f} of the LFE away" if share > most else ""


def fnv1a(data):
    """The digest of FNV-1a, 64 bits."""
    digest = 0xcbf29ce484222325
    for byte in data:
        digest = (digest ^ byte) * 0x100000001b3 % 2**64
    return digest


def digests(mesh):
    return [f"{a.name.decode()} {fnv1a(a.values.tobytes()):x}" for a in mesh.attributes]


def compare(stem):
    with open(stem + ".dmsh", "rb") as file:
        mesh = decode(file.read())
    positions, faces = read_off(stem + ".off")
    wrong = wrong_positions(mesh, positions)
    if not np.array_equal(faces, np.array(mesh.faces).reshape(-1, 3)):
        wrong += " faces differ"
    if os.path.exists(stem + ".digests"):
        with open(stem + ".digests", encoding="ascii") as file:
            lines = file.read().split("\n")
        expected, groups = lines[:len(mesh.attributes)], lines[len(mesh.attributes)]
        wrong += "".join(f" {a} in place of {b}" for a, b in zip(digests(mesh), expected) if a != b)
        if groups != "".join(map(str, mesh.groups or [])):
            wrong += " groups differ"
    return wrong.strip()


def tag_of(path):
    """The rule that a stream of the folder `invalid` breaks."""
    return os.path.basename(path).split(".")[0]


def compare_invalid(stem):
    try:
        with open(stem + ".dmsh", "rb") as file:
            decode(file.read())
    except Broken as error:
        return "" if error.tag == tag_of(stem) else str(error)
    return "decodes"


def printed(name, option):
    """What the decoder as a program prints of a golden stream."""
    stream, = glob.glob(os.path.join(GOLDEN, name + ".v1d*.dmsh"))
    return subprocess.run([sys.executable, DECODER, stream, option], capture_output=True, text=True, check=True).stdout


def wrong_options():
    """Why what the options print is not as it should be; an empty text if it is."""
    header = json.loads(printed("sphere.anchors", "--json"))
    if header["anchors"] != 240 or header["attributes"]:
        return "--json"
    names = {line.split(":")[0] for line in printed("sphere.anchors", "--dump").split("\n")}
    lacking = {"faces", "decision", "symbol", "deltas", "level", "edges by node", "interpolation by node"} - names
    return f"--dump lacks {lacking}" if lacking else ""


def main():
    folder, failed = GOLDEN, 0
    stems = sys.argv[1:] or [os.path.join(folder, f[:-5]) for f in sorted(os.listdir(folder)) if f.endswith(".dmsh")]
    stems += [f[:-5] for f in sorted(glob.glob(os.path.join(folder, "invalid", "*.dmsh")))] * (not sys.argv[1:])
    for stem in stems:
        try:
            wrong = (compare_invalid if os.path.basename(os.path.dirname(stem)) == "invalid" else compare)(stem)
        except Exception as error:  # any failure is one of this stream
            wrong = f"{type(error).__name__} {error}"
        print(f"{os.path.basename(stem)}: {wrong or 'ok'}")
        failed += bool(wrong)
    print(f"{len(stems) - failed} of {len(stems)} streams decode as expected")
    if wrong := "" if sys.argv[1:] else wrong_options():
        print(f"options: {wrong}")
    return failed > 0 or not stems or bool(wrong)


if __name__ == "__main__":
    sys.exit(main())
