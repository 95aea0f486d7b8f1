"""Numbers, container, header and chunks: format.md, rules CON, CNT, HDR, DIR and ENT."""
import math
import struct

import numpy as np
import xxhash
import zstandard

DRAFT, LARGEST_F32 = 26, 3.4028234663852886e38
KINDS = ["", "CONN", "SEAM", "FGRP", "DELT", "ANCH", "POSN", "ATTR", "ORDR", "GRID"]
ZSTD, COMPACT = 1, 2
HIGHPASS, LATTICE, VOXELS, FLOATS = range(4)

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

class Reader:
    """[CON-1] Reads numbers one after the other."""
    coder = None  # of the compact coding, where that reads what is left

    def __init__(self, data):
        self.data, self.at = data, 0

    def bytes(self, count):
        must(self.at + count <= len(self.data), "CON-1", "the bytes end within a number")
        self.at += count
        return self.data[self.at - count:self.at]

    def rest(self):
        return self.bytes(len(self.data) - self.at)

    def number(self, form):
        """A fixed-width number, `form` as in the module struct."""
        return struct.unpack("<" + form, self.bytes(struct.calcsize(form)))[0]

    def u8(self):
        return self.number("B")

    def f24(self):
        """[CON-6]"""
        return struct.unpack("<f", b"\0" + self.bytes(3))[0]

    def varint(self, most=2**64 - 1, tag=""):
        """[CON-2]"""
        octets = [self.u8()]
        while octets[-1] >= 128 and len(octets) < 10:
            octets.append(self.u8())
        value = sum((octet & 127) << 7 * i for i, octet in enumerate(octets))
        must(octets == [0] or octets[-1], "CON-2", "a varint is not in its shortest form")
        must(octets[-1] < 128, "CON-2", "a varint of more than 10 bytes")
        must(value < 2**64, "CON-2", f"{value} has more than 64 bits")
        must(value <= most, tag, f"{value} is above {most}")
        return value

    def end(self):
        """[CON-3]"""
        must(self.at == len(self.data), "CON-3", f"{len(self.data) - self.at} bytes are left over")
        if self.coder:
            self.coder.CMP_3_end()

def nearest_f32(x):  # HDR-8
    """x rounded to the nearest finite f32."""
    return float(np.float32(min(max(x, -LARGEST_F32), LARGEST_F32)))

def all_finite(numbers):  # HDR-8, HDR-9, HDR-11, HDR-14
    return all(map(math.isfinite, numbers))

class Header:  # HDR-5 to HDR-14
    """The header's fields as attributes."""
    origin, vde, lfe, max_error, bits = [0.0] * 3, 0.0, 0.0, 0.0, 0

    def __init__(self, r):
        self.HDR_5_counts(r)
        self.origin = [r.number("d") for _ in range(3)] if self.flags & 2 else [0.0] * 3
        must(all_finite(self.origin), "HDR-8", "the origin is not finite")
        self.vde, self.lfe, self.max_error = figures = [r.f24() for _ in range(3)]
        must(all(0 <= x < math.inf for x in figures), "HDR-9", f"figures {figures}")
        self.bits = r.u8() if self.flags & 4 else 0
        self.geometry(r)

    def HDR_5_counts(self, r):
        """Flags and counts [HDR-5 to HDR-7]."""
        flags = self.flags = r.u8()
        self.restore_order, self.coder = bool(flags & 1), flags >> 6
        must(self.coder in (LATTICE, VOXELS) or not flags & 0x30, "HDR-5", f"flags {flags} without a lattice")
        must(self.coder != FLOATS or not flags & 8, "HDR-5", f"flags {flags} with floats")
        self.triangles, self.geometric, self.copies = r.varint(2**29, "HDR-6"), r.varint(), r.varint()
        self.vertices, self.components = self.geometric + self.copies, r.varint()
        must(self.vertices < 2**31, "HDR-6", "too many vertices")
        counts = [self.vertices, self.geometric, self.components]
        must(self.components <= self.geometric, "HDR-7", "more components than vertices")
        must(all(counts) or not any(counts), "HDR-7", f"counts {counts}")
        must(self.vertices or not self.triangles, "HDR-7", "triangles without vertices")

    def geometry(self, r):  # HDR-14
        """The fields of the geometry coder."""
        (self.HDR_11_highpass, self.HDR_14_lattice, self.HDR_14_lattice, self.HDR_8_box)[self.coder](r)
        must(self.coder == HIGHPASS or self.bits <= 28, "HDR-14", f"{self.bits} bits")

    def HDR_8_box(self, r):
        self.box_min, self.box_max = ([r.number("f") for _ in range(3)] for _ in range(2))
        must(all_finite(self.box_min + self.box_max), "HDR-8", "the box is not finite")
        must(all(a <= b for a, b in zip(self.box_min, self.box_max)), "HDR-8", "box min is above box max")

    def steps_of(self, r, count):  # HDR-11, HDR-14
        return [r.number("d") if self.flags & 8 else r.f24() for _ in range(count)]

    def HDR_11_highpass(self, r):
        self.HDR_8_box(r)
        self.step, = self.steps_of(r, 1)
        must(0 < self.step < math.inf, "HDR-11", f"step {self.step}")
        self.shift_ones, self.shift_others, self.anchor_bits = r.number("b"), r.number("b"), r.u8()
        self.anchors, self.density, self.cycles = r.varint(), r.varint(), r.u8()
        must(self.bits == 0 or 3 <= self.bits <= 16, "HDR-11", f"{self.bits} bits")
        must(4 <= self.anchor_bits <= 24, "HDR-11", f"{self.anchor_bits} bits of anchors")
        must(1 <= self.cycles <= 80, "HDR-11", f"{self.cycles} cycles")
        must(self.components <= self.anchors <= self.geometric, "HDR-11", f"{self.anchors} anchors")

    def HDR_14_lattice(self, r):
        self.steps = self.steps_of(r, 3) if self.flags & 16 else self.steps_of(r, 1) * 3
        self.HDR_14_steps()
        self.lattice_origin = [r.number("d") for _ in range(3)] if self.flags & 32 else [0.0] * 3
        must(all_finite(self.lattice_origin), "HDR-14", "the lattice origin is not finite")
        self.first = self.first_point(r)
        self.cells = [r.varint() for _ in range(3)]
        self.levels = self.HDR_14_levels(r) if self.coder == VOXELS else 1
        self.HDR_14_reach()

    def HDR_14_steps(self):
        must(all(0 < s < math.inf for s in self.steps), "HDR-14", f"steps {self.steps}")

    def HDR_14_levels(self, r):
        levels = r.varint(2**19, "HDR-14")
        must(levels >= 1, "HDR-14", "no levels")
        return levels

    def HDR_14_reach(self):
        must(all(abs(f) <= 2**48 for f in self.first), "HDR-14", "the first point is beyond 2^48")
        must(max(self.cells) <= 2**28, "HDR-14", f"{max(self.cells)} cells")
        self.box_min = [nearest_f32(self.POSN_2_place(a, 0)) for a in range(3)]
        self.box_max = [nearest_f32(self.POSN_2_place(a, self.cells[a])) for a in range(3)]

    def first_point(self, r):  # HDR-14, MAP-7
        return [unzigzag(r.varint()) for _ in range(3)]

    def POSN_2_place(self, axis, q):
        """The place of lattice coordinate q on an axis."""
        return self.lattice_origin[axis] + self.steps[axis] * float(self.first[axis] + q)

def ENT_1_expand(data, length):
    try:
        unzip = zstandard.ZstdDecompressor(max_window_size=2**31).decompressobj()
        payload = unzip.decompress(data)
    except zstandard.ZstdError as error:
        raise Broken("ENT-1", f"not a zstd frame: {error}") from error
    must(unzip.eof, "ENT-1", "the frame is cut")
    must(not unzip.unused_data, "ENT-1", "bytes after the frame")
    must(len(payload) == length, "ENT-1", f"{len(payload)} bytes in place of {length}")
    return payload

class Chunk(Reader):
    """[DIR-8] Reads the payload of a chunk; that of one that is not there is empty."""
    def __init__(self, tag="", is_compact=False, data=b"", descriptor=None):
        super().__init__(data)
        self.tag, self.is_compact, self.descriptor = tag, is_compact, descriptor

def DIR_2_chunk(r, header, read_descriptor):
    """[DIR-2, DIR-4, DIR-5, DIR-7] A chunk; nobody asks for one that is skipped."""
    byte = r.u8()
    kind, coding = byte & 15, byte >> 4
    must(coding <= COMPACT, "DIR-4", f"coding {coding}")
    must(kind <= 9, "DIR-2", f"kind {kind}")
    tag = KINDS[kind] if kind else r.bytes(4).decode("latin-1")
    must(tag.encode().isalpha(), "DIR-2", f"{tag!r} is no tag")
    must(kind or tag[3].islower(), "DIR-2", f"{tag} must not be skipped")
    length = r.varint()
    decoded = r.varint() if coding == ZSTD else length
    must(decoded <= 65536 * length, "DIR-5", "a chunk expands too much")
    must(not kind or decoded <= 1024 + 160 * (header.vertices + header.triangles), "DIR-5", "a payload is too long")
    descriptor = read_descriptor(r) if tag == "ATTR" else None
    must(length <= len(r.data) - r.at, "DIR-7", "a chunk reaches beyond the checksum")
    data = r.bytes(length)
    unread = ["POSN"] if header.coder == HIGHPASS else ["DELT", "ANCH"]  # [DIR-8]
    if coding == ZSTD and kind and tag not in unread + ["GRID"] + ["ORDR"] * (not header.restore_order):
        data = ENT_1_expand(data, decoded)
    return Chunk(tag, coding == COMPACT, data, descriptor)

def CNT_2_checked(data, tag="CNT-2", seed=0, before=b""):
    """The bytes before a checksum, which is of them and of those before."""
    digest = xxhash.xxh3_64_intdigest(before + data[:-4], seed=seed) % 2**32
    must(struct.pack("<I", digest) == data[-4:], tag, "the checksum does not match")
    return data[:-4]

def CNT_1_stream(data, read_descriptor):
    """[CNT-1 to CNT-5, HDR-1 to HDR-3, DIR-1, DIR-8] The header and the chunks."""
    r = Reader(data)
    must(r.bytes(3) == b"DMS", "HDR-1", "not a deltamesh stream")
    version = r.u8()
    must(version >= 128, "HDR-2", f"version {version}")
    must(version == 128 + DRAFT, "HDR-3", f"draft {version - 128}")
    r.data = CNT_2_checked(data)
    header = Header(r)
    must(header.vertices + header.triangles <= 2048 * len(data), "CNT-5", "more is stated than the bytes can hold")
    return header, CNT_4_chunks(r, header, read_descriptor)

def CNT_4_chunks(r, header, read_descriptor):
    chunks = []
    while r.at < len(r.data):
        must(len(chunks) < 65536, "DIR-1", "too many chunks")
        chunks.append(DIR_2_chunk(r, header, read_descriptor))
        tag, before = chunks[-1].tag, (chunk.tag for chunk in chunks[:-1])
        must(tag == "ATTR" or tag not in KINDS or tag not in before, "DIR-8", f"{tag} comes twice")
    return chunks
