"""Numbers, container, header and chunks: format.md, rules CON, CNT, HDR, DIR and ENT."""
import math
import struct

import xxhash
import zstandard

DRAFT = 13
KINDS = ["", "CONN", "SEAM", "FGRP", "DELT", "ANCH", "POSN", "ATTR", "ORDR"]
RAW, ZSTD, COMPACT = 0, 1, 2
HIGHPASS, LATTICE, VOXELS, FLOATS = 0, 1, 2, 3


class Broken(Exception):
    """A stream that breaks a rule; the message begins with the rule's tag."""

    def __init__(self, tag, what):
        super().__init__(f"[{tag}] {what}")
        self.tag = tag


def must(condition, tag, what):
    if not condition:
        raise Broken(tag, what)


def unzigzag(code):
    """[CON-4]"""
    return (code >> 1) ^ -(code & 1)


def wrap32(x):
    """The signed 32-bit integer that is congruent to x modulo 2^32."""
    return (x + 2**31) % 2**32 - 2**31


class Reader:
    """Reads numbers one after the other. `tag` is the rule that bytes which are missing break."""

    def __init__(self, data, tag="CON-1"):
        self.data, self.at, self.tag = data, 0, tag

    def bytes(self, count):
        must(self.at + count <= len(self.data), self.tag, "the bytes end within a number")
        self.at += count
        return self.data[self.at - count:self.at]

    def number(self, form):
        """[CON-1] A fixed-width number, `form` as in the module struct."""
        return struct.unpack("<" + form, self.bytes(struct.calcsize(form)))[0]

    def u8(self):
        return self.number("B")

    def f24(self):
        """[CON-6]"""
        return struct.unpack("<f", b"\0" + self.bytes(3))[0]

    def varint(self, most=2**64 - 1, tag="CON-2"):
        """[CON-2]"""
        value = 0
        for i in range(10):
            byte = self.u8()
            value |= (byte & 127) << 7 * i
            if byte < 128:
                must(byte > 0 or i == 0, "CON-2", "a varint is not in its shortest form")
                must(value < 2**64, "CON-2", "a varint has more than 64 bits")
                must(value <= most, tag, f"{value} is above {most}")
                return value
        raise Broken("CON-2", "a varint has more than 10 bytes")

    def planes(self, count):
        """[CON-5]"""
        planes = self.u8()
        must(planes <= 4, "CON-5", f"{planes} byte planes")
        symbols = [0] * count
        for plane in range(planes):
            symbols = [s | byte << 8 * plane for s, byte in zip(symbols, self.bytes(count))]
        return symbols

    def end(self):
        """[CON-3]"""
        must(self.at == len(self.data), "CON-3", f"{len(self.data) - self.at} bytes are left over")


def f32(x):
    """x rounded to the nearest finite f32."""
    try:
        return struct.unpack("<f", struct.pack("<f", x))[0]
    except OverflowError:
        return math.copysign(3.4028234663852886e38, x)


class Header:
    """The header [HDR-1 to HDR-14] as attributes."""

    def __init__(self, r):
        self.flags = r.u8()
        self.restore_order = bool(self.flags & 1)
        self.coder = self.flags >> 6
        is_lattice = self.coder in (LATTICE, VOXELS)
        must(is_lattice or not self.flags & 0x30, "HDR-5", "lattice flags without a lattice")
        must(self.coder != FLOATS or not self.flags & 8, "HDR-5", "steps' flag with floats")
        self.triangles = r.varint(2**29, "HDR-6")
        self.geometric = r.varint(2**31 - 1, "HDR-6")
        self.copies = r.varint(2**31 - 1, "HDR-6")
        self.vertices = self.geometric + self.copies
        must(self.vertices < 2**31, "HDR-6", "too many vertices")
        self.components = r.varint()
        must(self.components <= self.geometric, "HDR-7", "more components than vertices")
        empty = [self.vertices == 0, self.geometric == 0, self.components == 0]
        must(all(empty) or not any(empty), "HDR-7", "counts are 0 and not 0")
        must(self.triangles == 0 or not empty[0], "HDR-7", "faces without vertices")
        self.origin = [r.number("d") for _ in range(3)] if self.flags & 2 else [0.0] * 3
        must(all(map(math.isfinite, self.origin)), "HDR-8", "the origin is not finite")
        self.vde, self.lfe, self.max_error = r.f24(), r.f24(), r.f24()
        for figure in (self.vde, self.lfe, self.max_error):
            must(math.isfinite(figure) and figure >= 0, "HDR-9", "a figure is not finite or negative")
        self.bits = r.u8() if self.flags & 4 else 0
        (self.lattice if is_lattice else self.highpass if self.coder == HIGHPASS else self.box)(r)
        if self.coder != HIGHPASS:
            must(self.bits <= 28, "HDR-14", f"{self.bits} bits")

    def box(self, r):
        """[HDR-8]"""
        self.box_min = [r.number("f") for _ in range(3)]
        self.box_max = [r.number("f") for _ in range(3)]
        must(all(map(math.isfinite, self.box_min + self.box_max)), "HDR-8", "the box is not finite")
        must(all(a <= b for a, b in zip(self.box_min, self.box_max)), "HDR-8", "box min is above box max")

    def step_width(self, r):
        return r.number("d") if self.flags & 8 else r.f24()

    def highpass(self, r):
        """[HDR-11]"""
        self.box(r)
        self.step = self.step_width(r)
        must(math.isfinite(self.step) and self.step > 0, "HDR-11", "step is not finite and above 0")
        self.shift_ones, self.shift_others = r.number("b"), r.number("b")
        self.anchor_bits = r.u8()
        self.anchors, self.density = r.varint(), r.varint()
        self.cycles = r.u8()
        must(self.bits == 0 or 3 <= self.bits <= 16, "HDR-11", f"{self.bits} bits")
        must(4 <= self.anchor_bits <= 24, "HDR-11", f"{self.anchor_bits} bits of anchors")
        must(self.cycles <= 80, "HDR-11", f"{self.cycles} cycles")
        must(self.components <= self.anchors <= self.geometric, "HDR-11", f"{self.anchors} anchors")

    def lattice(self, r):
        """[HDR-14] and the box of [HDR-8]"""
        steps = [self.step_width(r) for _ in range(3 if self.flags & 16 else 1)]
        self.steps = steps * (3 // len(steps))
        must(all(math.isfinite(s) and s > 0 for s in steps), "HDR-14", "a step is not finite and above 0")
        self.lattice_origin = [r.number("d") for _ in range(3)] if self.flags & 32 else [0.0] * 3
        must(all(map(math.isfinite, self.lattice_origin)), "HDR-14", "the lattice origin is not finite")
        self.first = [unzigzag(r.varint()) for _ in range(3)]
        must(all(abs(f) <= 2**48 for f in self.first), "HDR-14", "the first point is beyond 2^48")
        self.cells = [r.varint(2**28, "HDR-14") for _ in range(3)]
        self.levels = r.varint() if self.coder == VOXELS else 1
        must(1 <= self.levels <= 2**19, "HDR-14", f"{self.levels} levels")
        self.box_min = [f32(self.point(a, 0)) for a in range(3)]
        self.box_max = [f32(self.point(a, self.cells[a])) for a in range(3)]

    def point(self, axis, q):
        """[POSN-2] The place of lattice coordinate q on an axis."""
        return self.lattice_origin[axis] + self.steps[axis] * float(self.first[axis] + q)


class Chunk:
    def __init__(self, kind, tag, coding, data, descriptor):
        self.kind, self.tag, self.coding, self.data, self.descriptor = kind, tag, coding, data, descriptor

    @property
    def is_compact(self):
        return self.coding == COMPACT


def expand(data, length):
    """[ENT-1]"""
    try:
        unzip = zstandard.ZstdDecompressor(max_window_size=2**31).decompressobj()
        payload = unzip.decompress(data)
    except zstandard.ZstdError as error:
        raise Broken("ENT-1", f"not a zstd frame: {error}") from error
    must(unzip.eof and not unzip.unused_data, "ENT-1", "the frame does not end with the chunk")
    must(len(payload) == length, "ENT-1", f"{len(payload)} bytes in place of {length}")
    return payload


def read_chunk(r, header, read_descriptor):
    """[DIR-2, DIR-4, DIR-5, DIR-7]"""
    byte = r.u8()
    kind, coding = byte & 15, byte >> 4
    must(kind <= 8, "DIR-2", f"kind {kind}")
    tag = KINDS[kind] if kind else r.bytes(4).decode("latin-1")
    if not kind:
        must(tag.isascii() and tag.isalpha() and tag not in KINDS, "DIR-2", f"tag {tag!r}")
        must(tag[3].islower(), "DIR-2", f"unknown chunk {tag} must not be skipped")
    must(coding <= COMPACT, "DIR-4", f"coding {coding}")
    length = r.varint()
    decoded = r.varint() if coding == ZSTD else length
    must(coding != ZSTD or decoded <= 65536 * length, "DIR-5", "a chunk expands too much")
    must(not kind or decoded <= 1024 + 160 * (header.vertices + header.triangles), "DIR-5", "a payload is too long")
    descriptor = read_descriptor(r) if tag == "ATTR" else None
    must(length <= len(r.data) - r.at, "DIR-7", "a chunk reaches beyond the checksum")
    data = r.bytes(length)
    if not kind:
        return None  # skipped [DIR-2]
    return Chunk(kind, tag, coding, expand(data, decoded) if coding == ZSTD else data, descriptor)


def read_stream(data, read_descriptor):
    """[CNT-1 to CNT-5, HDR-1 to HDR-3, DIR-1, DIR-8] The header and the chunks."""
    must(data[:3] == b"DMS", "HDR-1", "not a deltamesh stream")
    must(len(data) > 3, "CON-1", "the stream ends within the header")
    must(data[3] >= 128, "HDR-2", f"version {data[3]}")
    must(data[3] == 128 + DRAFT, "HDR-3", f"draft {data[3] - 128}")
    must(len(data) >= 8, "CON-1", "the stream has no checksum")
    checksum = struct.unpack("<I", data[-4:])[0]
    must(checksum == xxhash.xxh3_64_intdigest(data[:-4]) % 2**32, "CNT-2", "the checksum does not match")
    r = Reader(data[:-4])
    r.at = 4
    header = Header(r)
    must(header.vertices + header.triangles <= 2048 * len(data), "CNT-5", "more is stated than the bytes can hold")
    chunks, count = [], 0
    while r.at < len(r.data):  # [CNT-4]
        count += 1
        must(count <= 65536, "DIR-1", "too many chunks")
        chunk = read_chunk(r, header, read_descriptor)
        if chunk:
            must(chunk.tag == "ATTR" or all(c.tag != chunk.tag for c in chunks), "DIR-8", f"{chunk.tag} comes twice")
            chunks.append(chunk)
    return header, chunks
