"""ORDR: the original order of vertices and faces: ordr.md."""
from collections import defaultdict, deque

from coder import Coder, NumberModel, bits, divide, symbol_models
from container import must, unzigzag

def ORDR_1_read(chunk, faces, n):
    """The places of vertices, those of faces, and the rotations."""
    vertices, placed, rotations = ORDR_5_compact(Coder(chunk), faces, n)
    chunk.end()
    must(sorted(vertices) == list(range(n)), "ORDR-2", "the places of vertices are no permutation")
    must(sorted(placed) == list(range(len(faces))), "ORDR-2", "the places of faces are no permutation")
    return vertices, placed, rotations

class ORDR_4_Places:
    """The places of vertices, or those of faces."""
    def __init__(self, coder, count):
        self.coder, self.count, self.place, self.models = coder, count, {}, defaultdict(NumberModel)
        self.costs, self.length, self.following = [0, 0, 0], 0, 0

    def decode(self, i, guesses=None):
        guesses = guesses or [self.following] * 3
        code = self.models[self.length].decode(self.coder)
        place = (guesses[self.costs.index(min(self.costs))] + unzigzag(code)) % 2**32
        must(place < self.count, "ORDR-2", "a place is out of range")
        for k in range(3):
            difference = (place - guesses[k] + 2**31) % 2**32 - 2**31
            self.costs[k] += bits(max(2 * difference, -2 * difference - 1)) - (self.costs[k] >> 5)
        self.place[i], self.following, self.length = place, place + 1, bits(code)

def ORDR_5_compact(coder, faces, n):
    vertices, placed, rotations = ORDR_4_Places(coder, n), ORDR_4_Places(coder, len(faces)), []
    models, latest = symbol_models((8, 8, 8) + (1,) * 13), defaultdict(lambda: deque(maxlen=16))
    p = vertices.place
    for f, face in enumerate(faces):
        x, y, z = face
        gate = next((corner for corner in reversed(latest[y]) if corner[1] == x), None)
        for v in (x, y):
            if v not in p:
                vertices.decode(v)
        if z not in p:
            vertices.decode(z, gate and [vertices.following, p[x] + 1, p[x] + p[y] - p[gate[2]]])
        of = [p[v] for v in face]
        rotations.append(coder.symbol([models[3 * of.index(min(of)) + of.index(max(of))]]))
        must(rotations[-1] <= 2, "ORDR-3", f"rotation {rotations[-1]}")
        guesses, g = None, gate[0] if gate else f - 1
        if f:  # [ORDR-6]
            by = divide((max(of) - max(p[v] for v in faces[g])) * len(faces), n)
            guesses = [placed.following, placed.place[g] + 1, placed.place[g] + 1 + by]
        placed.decode(f, guesses)
        for v, after, before in ((x, y, z), (y, z, x), (z, x, y)):
            latest[v].append((f, after, before))
    for v in range(n):
        if v not in p:
            vertices.decode(v)
    return [p[v] for v in range(n)], [placed.place[f] for f in range(len(faces))], rotations
