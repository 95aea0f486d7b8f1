"""ORDR: the original order of vertices and faces: ordr.md."""
from coder import Coder, NumberModel, Models, bits, symbol_models
from container import Reader, must, unzigzag


def ORDR_1_read(chunk, faces, n):
    """The places of vertices, those of faces, and the rotations."""
    if chunk and chunk.is_compact:
        return ORDR_5_compact(chunk.data, faces, n)
    r, m = Reader(chunk.data if chunk else b""), len(faces)
    if not chunk or not chunk.data:
        must(n == 0 and m == 0, "ORDR-2", "no order for the vertices")
        return [], [], []
    places = [ORDR_2_check(ORDR_1_places(r.planes(count))) for count in (n, m)]
    rotations = r.planes(m)
    must(all(x <= 2 for x in rotations), "ORDR-3", "a rotation above 2")
    r.end()
    return places[0], places[1], rotations


def ORDR_1_places(codes):
    places, following = [], 0
    for code in codes:
        places.append((following + unzigzag(code)) % 2**32)
        following = places[-1] + 1
    return places


def ORDR_2_check(places):
    must(sorted(places) == list(range(len(places))), "ORDR-2", "the places are no permutation")
    return places


class Places:
    """[ORDR-4] The places of vertices, or those of faces."""

    def __init__(self, coder, count):
        self.coder, self.count = coder, count
        self.place, self.models, self.costs = {}, Models(NumberModel), [0, 0, 0]
        self.length, self.following = 0, 0

    def decode(self, i, guesses):
        guesses = guesses or [self.following] * 3
        guess = guesses[self.costs.index(min(self.costs))]
        code = self.models[self.length].decode(self.coder)
        self.length = bits(code)
        place = (guess + unzigzag(code)) % 2**32
        must(place < self.count, "ORDR-2", "a place is out of range")
        for k in range(3):
            difference = (place - guesses[k] + 2**31) % 2**32 - 2**31
            zigzag = 2 * difference if difference >= 0 else -2 * difference - 1
            self.costs[k] += bits(zigzag) - (self.costs[k] >> 5)
        self.place[i], self.following = place, place + 1

    def all(self):
        return ORDR_2_check([self.place[i] for i in range(self.count)])


def ORDR_5_compact(data, faces, n):
    coder, m = Coder(data), len(faces)
    vertices, placed = Places(coder, n), Places(coder, m)
    rotation_models, rotations = symbol_models((8, 8, 8) + (1,) * 13), []
    latest = {}  # the 16 latest corners at each vertex, as (face, corner), the latest last
    for f, face in enumerate(faces):
        x, y, _ = face
        gate = next((c for c in reversed(latest.get(y, [])) if faces[c[0]][(c[1] + 1) % 3] == x), None)
        for k, v in enumerate(face):
            if v in vertices.place:
                continue
            guesses = None
            if k == 2 and gate:
                u = faces[gate[0]][(gate[1] + 2) % 3]
                p = vertices.place
                guesses = [vertices.following, p[x] + 1, p[x] + p[y] - p[u]]
            vertices.decode(v, guesses)
        of = [vertices.place[v] for v in face]
        rotation = coder.symbol([rotation_models[3 * of.index(min(of)) + of.index(max(of))]])
        must(rotation <= 2, "ORDR-3", f"rotation {rotation}")
        rotations.append(rotation)
        placed.decode(f, ORDR_6_guesses(f, faces, gate, vertices, placed, m, n))
        for k, v in enumerate(face):
            latest[v] = (latest.get(v, []) + [(f, k)])[-16:]
    for v in range(n):
        if v not in vertices.place:
            vertices.decode(v, None)
    coder.end()
    return vertices.all(), placed.all(), rotations


def ORDR_6_guesses(f, faces, gate, vertices, placed, m, n):
    if f == 0:
        return None
    g = gate[0] if gate else f - 1
    def largest(face):
        return max(vertices.place[v] for v in faces[face])
    by = (largest(f) - largest(g)) * m
    return [placed.following, placed.place[g] + 1, placed.place[g] + 1 + (abs(by) // n if by >= 0 else -(abs(by) // n))]
