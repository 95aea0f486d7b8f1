"""Streams that break one rule each, for what changes by chance hardly reach; most are a tetrahedron with something wrong."""
import glob
import os
import random
import struct
import subprocess
import tempfile

import zstandard

from reference_decoder_test import GOLDEN
from container import COMPACT, DRAFT, KINDS, ZSTD
from other_decisions import with_other_decisions
from reference_examples_test import line
from stream_changes import Parts, sealed, varint

NAN, LONG_NAN = struct.pack("<f", float("nan")), struct.pack("<d", float("nan"))
STATES = b"\x44" + struct.pack("<2I", 2**31, 2**31)  # of a compact stream without decisions


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


def tetrahedron():
    return Parts(golden("tetrahedron.default"))


def f32(*numbers):
    return struct.pack(f"<{len(numbers)}f", *numbers)


def with_chunk(tag, payload, is_compact=False, descriptor=b"", flags=0):
    """The tetrahedron with one more chunk."""
    parts = tetrahedron()
    parts.header = parts.header[:4] + bytes([parts.header[4] | flags]) + parts.header[5:]
    parts.chunks.append((KINDS.index(tag) | is_compact * COMPACT << 4, descriptor, payload))
    return parts.stream()


def by_hand(program):
    yield from containers()
    yield from headers()
    yield from attributes()
    yield from faces()
    yield from grids()
    yield from plain(program)
    yield from by_chance(program)
    yield from others(program)


def containers():
    valid, header = golden("tetrahedron.default"), tetrahedron().header
    yield from (b"XMS" + valid[3:], valid[:3] + b"\1" + valid[4:], valid[:3] + bytes([127 + DRAFT]) + valid[4:],
                valid[:-1] + bytes([valid[-1] ^ 1]), valid[:7])
    for chunk in (b"\0AB1d\0", b"\0ABCD\0", b"\x0a\0", b"\x31\0", b"\6\1"):
        yield sealed(header + chunk)
    yield with_chunk("POSN", b"", True)
    yield sealed(header + b"\x11\1" + varint(65537) + b"\0")
    yield sealed(header + b"\x11\1" + varint(3000) + b"\0")  # 8 vertices and faces have no such chunk
    frame = zstandard.ZstdCompressor(write_checksum=False).compress(bytes(20))
    for cut, size in ((frame[:-1], 20), (frame + b"\0", 20), (frame, 21), (b"\0" + frame, 20)):
        yield sealed(header + bytes([1 | ZSTD << 4, len(cut), size]) + cut)
    yield with_chunk("SEAM", b"\0")


def headers():
    start, counts, figures = b"DMS" + bytes([128 + DRAFT]), b"\4\4\0\1", bytes(9)

    def stream(flags, *fields):
        return sealed(start + bytes([flags]) + b"".join(fields))
    for wrong in (b"\x80" * 10 + b"\1", b"\x80" * 9 + b"\2", b"\x80\0", varint(2**29 + 1) + b"\4\0\1",
                  b"\4" + varint(2**31 - 1) + b"\1\1", b"\4\4\0\5", b"\4\4\0\0", b"\1\0\0\0"):
        yield stream(64, wrong, b"\1\1\1"[:4 - len(wrong)], figures, f32(1)[1:], bytes(6))
    for wrong in (f32(float("inf"))[1:], f32(-1)[1:]):
        yield stream(64, counts, wrong, bytes(6), f32(1)[1:], bytes(6))
    lattice, highpass = f32(1)[1:] + bytes(6), (f32(1)[1:], bytes(2), b"\4", b"\4", b"\0", b"\1")
    for flags, fields in ((0x10, b""), (0x20, b""), (0xd0, b""), (0xc8, b"")):
        yield stream(flags, counts, figures, fields, bytes(40))
    yield stream(66, counts, LONG_NAN * 3, figures, lattice)
    for box in (NAN * 6, f32(1) * 3 + f32(0) * 3):
        yield stream(192, counts, figures, box)
    for at, wrong in enumerate((f32(0)[1:], None, b"\3", b"\5", None, b"\x51")):
        if wrong:
            yield stream(0, counts, figures, f32(0) * 6, *highpass[:at], wrong, *highpass[at + 1:])
    yield stream(4, counts, figures, b"\2", f32(0) * 6, *highpass)
    yield stream(68, counts, figures, b"\x1d", lattice)
    yield stream(64, counts, figures, f32(0)[1:], bytes(6))
    yield stream(96, counts, figures, f32(1)[1:], LONG_NAN * 3, bytes(6))
    yield stream(64, counts, figures, f32(1)[1:], varint(2**49 + 2), bytes(5))
    yield stream(64, counts, figures, f32(1)[1:], bytes(3), varint(2**28 + 1), bytes(2))
    for levels in (0, 2**19 + 1):
        yield stream(128, counts, figures, lattice, varint(levels))
    yield stream(64, bytes(4), figures, lattice, b"\x26\1\0")  # no vertices, but a payload of positions
    yield stream(64, varint(200000), b"\4\0\1", figures, lattice)
    two = tetrahedron()
    two.header = two.header[:8] + b"\2" + two.header[9:]  # components
    yield two.stream()
    large = tetrahedron()
    large.header = large.header.replace(f32(large.fields.steps[0])[1:], b"\0\0\x7f")  # 2^127
    yield large.stream()
    # A component of four vertices, of which three are anchors.
    conn = bytes.fromhex("010d 01 000000 030100 040103 020301")
    yield stream(0, counts, figures, f32(0) * 6, *highpass[:3], b"\3\0\1", conn, b"\5\7\1\0\2\2" + bytes(3))


def attributes():
    """Descriptors and fields of attributes that are out of range."""
    byte, word, weights = b"\0\3\1\1\0\0", b"\0\3\5\1\0\0", b"\x0e"
    for wrong in (b"\x16", b"\0\7\1\1\0\0", b"\0\3\x08\1\0\0", b"\0\3\1\0\0\0", b"\0\3\1\x11\0\0", b"\0\3\1\1\2\0",
                  b"\x81" + f32(float("inf"))[1:], b"\x81" + f32(-1)[1:], b"\x51" + f32(float("inf"))[1:], b"\x51" + f32(-1)[1:]):
        yield with_chunk("ATTR", b"", False, wrong)
    for payload in (b"\x0c", b"\4", b"\0"):
        yield with_chunk("ATTR", payload, True, byte)
    for descriptor, payload in ((b"\1", b"\4\6" + f32(1)), (b"\1", b"\4\x40" + f32(1)), (b"\1", b"\4\0" + f32(2)), (b"\3", b"\5" + f32(0)),
                                (b"\2", b"\6" + f32(0)), (weights, b"\x09\0"), (weights, b"\x09\2"),
                                (weights, b"\x09" + varint(65537))):
        yield with_chunk("ATTR", payload + STATES, True, descriptor)
    for fields in (b"\x09", b"\x08\x80\0", b"\x08\0\0\2", b"\x08\0\0\xff\0\1"):
        yield with_chunk("ATTR", b"\7" + fields + bytes(8) + STATES, True, b"\5")
    for descriptor, fields in ((b"\x11", b"\2\1"), (b"\x12", b"\1\3"), (b"\x12", b"\1\0"), (b"\x11", b"\3\0")):
        yield with_chunk("ATTR", b"\x0b" + fields + bytes(2) + STATES, True, descriptor)
    for scale in (f32(0) * 2, f32(0) + f32(float("inf")), f32(float("inf")) + f32(1)):
        yield with_chunk("ATTR", b"\x0b" + scale + b"\1\0" + STATES, True, b"\0\3\6\1\0\0")
    one, base = f32(1), varint(2**53 + 1)
    for fields in (b"\6", b"\1", b"\4\0", b"\4" + varint(4097), b"\5\0", b"\2" + NAN, b"\3" + one + NAN, b"\2" + one + base,
                   b"\2" + one + b"\0" + varint(2**28 + 1)):
        yield with_chunk("ATTR", b"\x08" + fields + bytes(12) + STATES, True, word)
    for fields in (b"\5\xff", b"\2" + f32(3e38) + varint(2**50) + b"\0"):  # an exponent, and a point beyond f32
        yield with_chunk("ATTR", b"\x08" + fields + STATES, True, b"\0\3\6\1\0\0")
    # Exceptions: no value, too many, no run, too many, a run that begins or ends too late or comes behind the last vertex, a value too far.
    for fields in (b"\0", b"\5", b"\1\7\0", b"\1\7\5", b"\1\7\1\4", b"\1\7\1\0\4", b"\1\7\2\0\3", b"\2\7\x08\1\0\0\2"):
        yield with_chunk("ATTR", b"\x88" + fields + bytes(12) + STATES, True, byte)
    # A joint and a weight of a copy that are out of range.
    for descriptor, payload in ((b"\x0c", "0a771b40a056a2aabbea88056cd6ecc5afb6a64c81e400a15ebc83217fe867b6f784730681029dd3b0567ab5"),
                                (b"\x0e", "090f77c10755ad4b9b61d827bd6ec9d76147f0ba92013f56ea2725c312d14c6409")):
        copies = Parts(two_faces())
        copies.chunks.append((7 | COMPACT << 4, descriptor, bytes.fromhex(payload)))
        yield copies.stream()
    # A rule of normals without positions.
    highpass = Parts(golden("seam.step"))
    highpass.chunks.append((7 | COMPACT << 4, b"\1", b"\4\1" + one + STATES))
    yield highpass.stream()


def faces():
    """CONN payloads with too many faces, or too few vertices for them."""
    parts = tetrahedron()
    parts.header, parts.chunks = parts.header[:5] + varint(43000) + parts.header[6:], [(1 | COMPACT << 4, b"", b"\0")]
    yield parts.stream()
    few = tetrahedron()
    few.header = few.header[:6] + b"\3" + few.header[7:]  # geometric vertices
    yield few.stream()


# Of grid.md's example: payloads of GRID and CONN.
GRID, CONN = line("grid.md", "payload", bytes), line("grid.md", "conn", bytes)
# Without a rest: a node inside, and a face that leads to (7, 7, 7) inside the last cube, beyond all that is cut.
INNER = bytes.fromhex("788d80a6f011b9d708848963b9feafb5")


def grid(counts=(10, 8), cells=(8, 8, 8), levels=2, payloads=(GRID, CONN)):
    """A stream of a grid: triangles, vertices; cells; payloads of GRID and CONN."""
    header = b"DMS" + bytes([128 + DRAFT, 0x80, *counts, 0, 1]) + bytes(9) + f32(1)[1:] + bytes(3)
    chunks = b"".join(bytes([KINDS.index(tag) | COMPACT << 4, len(payload)]) + payload
                      for tag, payload in zip(("GRID", "CONN"), payloads) if payload)
    return sealed(header + b"".join(map(varint, (*cells, levels))) + chunks)


def grids():
    """The example of grid.md with something wrong."""
    for counts in ((0, 8), (9, 8), (11, 8), (10, 6), (10, 7), (10, 9)):
        yield grid(counts)
    yield grid(cells=(2**28,) * 3, levels=1)
    yield grid(cells=(6, 8, 8))
    yield grid((9, 7), (6, 6, 6), payloads=(INNER, b""))
    yield grid((9, 7), payloads=(INNER, CONN))
    yield grid(payloads=(b"",) * 2)  # no chunk is compact


def by_chance(program):
    """Faces and orders with other decisions."""
    rng = random.Random(5)
    torus = generated(program, "torus", 60, "--geometry predictive --keep-order")
    for stream, tag, firsts, tries in ((golden("tetrahedron.default"), "CONN", range(4), 400), (two_faces(), "CONN", range(4), 200),
                                       (torus, "CONN", range(20), 150), (torus, "ORDR", range(-8, 0), 80),
                                       (grid(), "GRID", range(60), 1200), (golden("room.odd"), "GRID", range(2000), 150),
                                       (golden("room.odd"), "GRID", range(-200, 0), 300),
                                       (golden("room.glued"), "CONN", range(-30, 0), 300)):
        i, parts = next((i, Parts(stream)) for i, chunk in enumerate(Parts(stream).chunks) if KINDS[chunk[0] & 15] == tag)
        kind, descriptor, payload = parts.chunks[i]
        for _ in range(tries):
            parts.chunks[i] = kind, descriptor, with_other_decisions(stream, payload, rng.choice(firsts), rng)
            yield parts.stream()
    i, parts = next((i, Parts(torus)) for i, chunk in enumerate(Parts(torus).chunks) if KINDS[chunk[0] & 15] == "ORDR")
    kind, descriptor, payload = parts.chunks[i]
    for _ in range(200):  # to their ends: no permutation
        parts.chunks[i] = kind, descriptor, with_other_decisions(torus, payload, rng.choice(range(-40, 0)), rng, ends=True)
        yield parts.stream()


def plain(program):
    """Streams of the plain form."""
    def changed(parts, tag, payload):
        return Parts(parts.stream()).replace(tag, None, payload)
    seam, groups = Parts(golden("seam.zstd")), Parts(golden("groups.zstd"))
    yield changed(seam, "CONN", b"\1" + b"\xff" * (3 * seam.fields.triangles))
    yield changed(seam, "CONN", b"")
    for code in (0, 1, 255):  # too many geometric vertices, too few, and one out of turn
        yield changed(seam, "SEAM", b"\1" + bytes([code]) * seam.fields.vertices)
    yield changed(seam, "SEAM", b"\1\0" + bytes([1]) * (seam.fields.vertices - 1))
    yield changed(groups, "FGRP", b"\3" + b"\1" * (3 * groups.fields.triangles))
    yield changed(groups, "FGRP", b"\5" + b"\1" * (5 * groups.fields.triangles))
    yield with_chunk("FGRP", b"\0")  # plain in a compact stream
    torus = Parts(generated(program, "torus", 60, "--profile zstd"))
    yield changed(torus, "POSN", (b"\4" + b"\xff" * (4 * torus.fields.geometric)) * 3)
    fragments = Parts(generated(program, "fragments", 60, "--geometry highpass --profile zstd"))
    count = fragments.fields.anchors
    for anchors in (b"\0", b"\1" + b"\2" * count, b"\1" + b"\xfe" * count, b"\4" + b"\xfe" * (4 * count)):
        yield changed(fragments, "ANCH", anchors + b"\0\0\0")
    ascending = b"\1\0" + b"\2" * (count - 1)
    yield changed(fragments, "ANCH", ascending + b"\4" + b"\xfe" * (4 * count) + b"\0\0")
    last = bytes([2 * (fragments.fields.geometric - count)])  # not in all components
    yield changed(fragments, "ANCH", b"\1" + last + ascending[2:] + b"\0\0\0")
    large = Parts(golden("grid.zstd"))
    for step, larger in ((f32(large.fields.step)[1:], b"\0\0\x7f"), (struct.pack("<d", large.fields.step), struct.pack("<d", 1e300))):
        large.header = large.header.replace(step, larger)
    yield large.stream()
    for coding in (b"\x0b", b"\x3f"):  # not of this shape, and none
        yield with_chunk("ATTR", coding, True, b"\0\3\1\1\0\0")
    for coding in (b"\1", b"\2"):
        yield with_chunk("ATTR", coding + struct.pack("<dq", 1, 0) + b"\0", False, b"\0\3\6\1\0\0")
    for step in (-1, float("inf"), float("nan")):
        yield with_chunk("ATTR", b"\0" + struct.pack("<d", step) + b"\0", False, b"\0\3\6\1\0\0")
    for first in (2**52 + 1, -2**52 - 1):
        yield with_chunk("ATTR", b"\0" + struct.pack("<dq", 1, first) + b"\0", False, b"\0\3\6\1\0\0")
    for step in (struct.pack("<dq", 2, 0), struct.pack("<d", 0)):  # of directions
        yield with_chunk("ATTR", b"\1" + step + b"\0", False, b"\1")


def others(program):
    for payload in (b"", b"\x99", b"\x11\1", b"\x11\1\1", STATES + b"\0", b"\x44" + struct.pack("<2I", 2**31, 2**30)):
        parts = tetrahedron()
        parts.chunks[1] = parts.chunks[1][0], b"", payload
        yield parts.stream()


def two_faces():
    """The two faces with two vertices in common that are the examples of conn.md, seam.md and posn.md."""
    header = b"DMS" + bytes([128 + DRAFT, 64]) + b"\2\4\2\1" + bytes(9) + f32(1)[1:] + b"\0\0\0\4\4\3"
    chunks = (1, "439eeaabbbe51d02"), (2, "3361cb1d5ee536"), (6, "56189dbd3e209ec4d3bb4913")
    return sealed(header + b"".join(bytes([kind | COMPACT << 4, len(payload) // 2]) + bytes.fromhex(payload) for kind, payload in chunks))


def unfinished():
    """Streams of few vertices with compact chunks that lack their decisions: only changes by chance make something of them."""
    fields = (("FGRP", b"", b""), ("ATTR", b"\1", b"\4\x38" + f32(1e-3)), ("ATTR", b"\3", b"\5" + f32(1)), ("ATTR", b"\2", b"\6" + f32(1)),
              ("ATTR", b"\0\3\5\1\0\0", b"\x08\2" + f32(1) + b"\0" + varint(2**28)), ("ATTR", b"\x0b", b"\x0a"), ("ATTR", b"\x0e", b"\x09\5"))
    yield two_faces()
    for stream in (golden("tetrahedron.default"), two_faces()):
        for tag, descriptor, payload in fields:
            parts = Parts(stream)
            parts.chunks.append((KINDS.index(tag) | COMPACT << 4, descriptor, payload + STATES))
            yield parts.stream()
    for flags, fields in ((64, f32(1)[1:] + bytes(3) + varint(2**28) * 3), (192, bytes(24))):
        parts = tetrahedron()
        parts.header = parts.header[:4] + bytes([flags]) + b"\4\4\0\1" + bytes(9) + fields
        parts.chunks[1] = parts.chunks[1][0], b"", STATES
        yield parts.stream()


def variants():
    """More streams for places that have one: what the program once took in another way."""
    def with_bytes(extra):
        return sealed(tetrahedron().stream()[:-4] + extra)
    yield "unread and too long", with_bytes(b"\x14\5" + varint(30000) + bytes(5))
    yield "unread and twice", with_bytes(b"\4\0\4\0")
    yield "a varint is cut", with_bytes(b"\4\x80")
    yield "planes are cut", sealed(Parts(golden("grid.zstd")).stream()[:-4] + b"\3\2\1\1")
    yield "beyond 32 bits", sealed(b"DMS" + bytes([128 + DRAFT, 64]) + varint(2**35) + b"\4\0\1" + bytes(9) + f32(1)[1:] + bytes(6))
    yield "a dictionary", sealed(Parts(golden("grid.zstd")).stream()[:-4] + b"\x13\x0e\4" + b"\x28\xb5\x2f\xfd\x21\1\4\x21\0\0" + b"\0\0\0\0")
