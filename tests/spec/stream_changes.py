"""Streams with a few bytes changed, and a checksum that matches."""
import struct

import xxhash

from other_decisions import with_other_decisions
from attr import Attribute
from container import COMPACT, DIR_2_chunk, DRAFT, Header, KINDS, Reader, ZSTD


def sealed(data):
    return data + struct.pack("<I", xxhash.xxh3_64_intdigest(data) % 2**32)


def of_this_draft(data):
    """The stream as one of this draft."""
    return sealed(data[:3] + bytes([128 + DRAFT]) + data[4:-4])


def varint(value):
    return bytes([value]) if value < 128 else bytes([value & 127 | 128]) + varint(value >> 7)


class Parts:
    """The header of a valid stream and its chunks as (kind and coding, descriptor, payload), zstd ones as raw."""
    def __init__(self, data):
        r = Reader(data[:-4])
        r.at = 4
        header, self.chunks, spans = Header(r), [], []
        self.header, self.fields = data[:r.at], header

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

    def replace(self, tag, coding, payload):
        """Gives the chunk another payload, raw where it is for `coding` None; an attribute's chunk is the first of that coding."""
        for i, (kind, descriptor, before) in enumerate(self.chunks):
            if KINDS[kind & 15] == tag and coding in (None, before[:1]):
                self.chunks[i] = kind & 15 if coding is None else kind, descriptor, payload
                return self.stream()
        raise ValueError(f"no chunk {tag}")

    def change(self, rng):
        """Changes the header, or one chunk."""
        if rng.random() < 0.2 or not self.chunks:
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


def changed(data, rng):
    """A valid stream with changed bytes, or with changed decisions of a compact chunk."""
    how, parts = rng.random(), Parts(data)
    compact = [i for i, (kind, _, _) in enumerate(parts.chunks) if kind >> 4 == COMPACT]
    if how < 0.1:
        return sealed(data[:4] + with_changes(data[4:-4], rng))
    if how < 0.6 or not compact:
        parts.change(rng)
    else:
        i = rng.choice(compact)
        kind, descriptor, payload = parts.chunks[i]
        first = int(200**rng.random() - 1) if rng.random() < 0.7 else -int(20**rng.random())
        parts.chunks[i] = kind, descriptor, with_other_decisions(data, payload, first, rng)
    return parts.stream()
