"""Messages about maps, but for parts: map.md, MAP-1, MAP-23 and MAP-25."""
import math

import xxhash

from container import CNT_2_checked, DRAFT, Reader, must

def MAP_1_fields(message, kind):
    """The fields of a message of this kind."""
    must(message[:5] == b"DMM" + bytes([128 + DRAFT, kind]), "MAP-1", f"no message of kind {kind} of this draft")
    return Reader(CNT_2_checked(message, "MAP-1")[5:])

class Pose:
    """[MAP-23] Where a map is, and when."""
    def __init__(self, message):
        r = MAP_1_fields(message, 10)
        self.map, self.start, self.number, self.stamp = r.number("Q"), r.varint(), r.varint(), r.number("Q")
        self.rotation, self.translation = [r.number("d") for _ in range(4)], [r.number("d") for _ in range(3)]
        must(abs(math.hypot(*self.rotation) - 1) <= 1e-6, "MAP-23", "no unit quaternion")
        must(all(math.isfinite(x) for x in self.translation), "MAP-23", "a translation that is not finite")
        r.end()

def MAP_25_whole(fragments):
    """The message that fragments in any order make, each perhaps more than once; None: some octets have not come."""
    octets, size = {}, 1
    for fragment in fragments:
        r = MAP_1_fields(fragment, 11)
        digest, size, offset, piece = r.number("Q"), r.varint(262144, "MAP-25"), r.varint(), r.rest()
        must(0 < len(piece) < size and offset + len(piece) <= size, "MAP-25", "no piece of its message")
        octets |= dict(enumerate(piece, offset))
    if len(octets) < size:
        return None
    whole = bytes(octets[i] for i in range(size))
    must(xxhash.xxh3_64_intdigest(whole) == digest and whole[4] != 11, "MAP-25", "another message, or a fragment")
    return whole
