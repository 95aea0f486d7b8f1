"""ORDR: the original order of vertices and faces: ordr.md."""
from collections import defaultdict

from coder import Coder, NumberModel, bits, symbol_models
from container import Reader, must, unzigzag

def ORDR_1_read(chunk, faces, n):
    """The places of vertices, those of faces, and the rotations."""
    m, data = len(faces), chunk.data
    if chunk.is_compact:
        return ORDR_5_compact(data, faces, n)
    r, runs = Reader(data), []
    for count in (n, m):
        places, following = [], 0
        for code in r.planes(count) if data or n else []:
            places.append((following + unzigzag(code)) % 2**32)
            following = places[-1] + 1
        runs.append(ORDR_2_permutation(places))
    rotations = r.planes(m) if data or n else []
    must(all(x <= 2 for x in rotations), "ORDR-3", "a rotation above 2")
    r.end()
    return runs + [rotations]

def ORDR_2_permutation(places):
    must(sorted(places) == list(range(len(places))), "ORDR-2", "the places are no permutation")
    return places

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
            self.costs[k] += bits(2 * difference if difference >= 0 else -2 * difference - 1) - (self.costs[k] >> 5)
        self.place[i], self.following, self.length = place, place + 1, bits(code)

    def all(self):
        return ORDR_2_permutation([self.place[i] for i in range(self.count)])

def ORDR_5_compact(data, faces, n):
    coder, m = Coder(data), len(faces)
    vertices, placed, rotations = ORDR_4_Places(coder, n), ORDR_4_Places(coder, m), []
    rotation_models, latest = symbol_models((8, 8, 8) + (1,) * 13), defaultdict(list)  # latest corners at each vertex
    p = vertices.place
    for f, face in enumerate(faces):
        x, y, _ = face
        gate = next(((g, k) for g, k in reversed(latest[y]) if faces[g][(k + 1) % 3] == x), None)
        for k, v in enumerate(face):
            if v not in p:
                by_gate = k == 2 and gate and [vertices.following, p[x] + 1, p[x] + p[y] - p[faces[gate[0]][(gate[1] + 2) % 3]]]
                vertices.decode(v, by_gate)
        of = [p[v] for v in face]
        rotations.append(coder.symbol([rotation_models[3 * of.index(min(of)) + of.index(max(of))]]))
        must(rotations[-1] <= 2, "ORDR-3", f"rotation {rotations[-1]}")
        placed.decode(f, f and ORDR_6_guesses(gate[0] if gate else f - 1, max(of), faces, p, placed, m, n))
        for k, v in enumerate(face):
            latest[v] = (latest[v] + [(f, k)])[-16:]
    for v in range(n):
        if v not in p:
            vertices.decode(v)
    coder.end()
    return vertices.all(), placed.all(), rotations

def ORDR_6_guesses(g, largest, faces, p, placed, m, n):
    by = (largest - max(p[v] for v in faces[g])) * m
    return [placed.following, placed.place[g] + 1, placed.place[g] + 1 + (abs(by) // n if by >= 0 else -(abs(by) // n))]
