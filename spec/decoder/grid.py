"""GRID: surfaces in the cubes of a grid: grid.md but for what cubes.py has."""
from collections import defaultdict, deque
from logging import debug
from types import SimpleNamespace

from coder import Coder, CountedBit, Fresh, Mixture, NumberModel, States, SymbolModel, bits, clamp
from container import must, unzigzag
from cubes import FACES, brick_of, corner_of, edge_between, edge_of, moved
from glue import CONN_8_faces
from known import (FormerLevels, MAP_28_beside, MAP_28_flag, MAP_28_fresh_beside, MAP_28_fresh_flag, MAP_28_fresh_pattern, MAP_28_fresh_sign, MAP_28_pattern,
                   MAP_28_sign, NothingKnown)
from lattice import POSN_2_positions, POSN_3_known, POSN_8_table, PredictedCoder

INSIDE, ONE_OVER = 12, (0, 256, 128, 85, 64)

def GRD_3_fresh(number):
    return CountedBit((49152, 24576, 8192, 4096)[min(number >> 3 & 7, 3)])

def GRD_4_fresh(number):
    return CountedBit((20000, 32768, 45536)[number % 3])

def even_weights(count):  # GRD-6, GRD-10
    return [int(s < count) for s in range(16)]

def even_model(count):  # GRD-6
    return SymbolModel(even_weights(count))

def GRD_10_fresh(symbols):
    """Models by table and number."""
    def fresh(key):
        table, number = key
        c, weights = number // 24, even_weights(symbols)
        if table == 1 and c:
            for s in range(symbols):
                weights[s] = max(3072 // (64 + (32 * (2 * s + 1) // symbols - 32 - (4 * c - 42))**2), 1)
        return SymbolModel(weights)
    return fresh

class Patterns:
    """[GRD-5, GRD-6] Patterns that are known, and the models of new ones."""
    def __init__(self):
        self.known, self.is_other, self.rank = defaultdict(list), defaultdict(lambda: CountedBit(1500)), SymbolModel((0, 4, 2) + (1,) * 12 + (4,))
        self.is_any, self.joins, self.apex = CountedBit(6000), CountedBit(), {k: even_model(k - 2) for k in range(4, 13)}
        self.count, self.corners = even_model(16), [even_model(13) for _ in range(3)]

    def GRD_5_pattern(self, coder, signs):
        """The triangles of a cube with these signs."""
        known = self.known[signs]
        if known and not self.is_other[signs].decode(coder):
            return known[0]
        place = coder.symbol([self.rank]) if known else 0
        must(place or not known, "GRD-5", "place 0 of a pattern that is not the first")
        if place < len(known):
            known[place - 1], known[place] = known[place], known[place - 1]
            return known[place - 1]
        fresh = self.GRD_6_any(coder) if self.is_any.decode(coder) else self.GRD_6_loops(coder, signs)
        must(fresh, "GRD-6", "a pattern without triangles")
        turns = [min((t[i:] + t[:i] for i in range(3)), key=lambda turn: turn[0]) for t in fresh]
        known[min(len(known), 14):] = [sorted(turns)]
        return known[-1]

    def GRD_6_any(self, coder):
        triangles = [tuple(coder.symbol([model]) for model in self.corners) for _ in range(coder.symbol([self.count]))]
        must(all(len({*t}) == 3 and max(t) <= INSIDE for t in triangles), "GRD-6", f"triangles {triangles}")
        return triangles

    def GRD_6_loops(self, coder, signs):
        follows, triangles = {}, []
        for around in FACES:
            out = [signs >> corner & 1 for corner in around]
            ambiguous = out in ([0, 1, 0, 1], [1, 0, 1, 0])
            joins_outside = self.joins.decode(coder) if ambiguous else 1
            edge = [edge_between(around[i], around[(i + 1) % 4]) for i in range(4)]
            ends = [i for i in range(4) if out[i] and not out[(i + 1) % 4]]
            for i in range(4):
                if not out[i] and out[(i + 1) % 4]:
                    after = min(ends, key=lambda j: (j - i) % 4) if joins_outside else max(ends, key=lambda j: (j - i) % 4)
                    follows[edge[after]] = edge[i]
        polygons = deque()
        while follows:
            polygon = [min(follows)]
            while (edge := follows.pop(polygon[-1])) != polygon[0]:
                polygon.append(edge)
            polygons.append(polygon)
        while polygons:
            v = polygons.popleft()
            k = len(v)
            if k >= 3:
                j = 1 + (coder.symbol([self.apex[k]]) if k > 3 else 0)
                must(j <= k - 2, "GRD-6", f"corner {j} of {k}")
                triangles.append((v[-1], v[0], v[j]))
                polygons.extendleft([v[j:], v[:j + 1]])
        return triangles

class Surface:
    """[GRD-3 to GRD-8] `nodes`, which are outside; `faces`; `edges`, the vertices on them; `inner`, where vertices inside cubes are."""
    def __init__(self, coder, header, most_faces, states, known):
        self.coder, self.header, self.most_faces, self.width = coder, header, most_faces, 2 * header.levels
        self.nodes, self.faces, self.edges, self.inner, self.count, self.bricks = {}, [], {}, {}, 0, set()
        learnt = states.models("grid", flags=Fresh(GRD_3_fresh), signs=Fresh(GRD_4_fresh), patterns=Patterns())
        self.flags, self.signs, self.patterns = learnt.flags, learnt.signs, learnt.patterns
        self.without, self.seen, self.waiting, self.known = defaultdict(lambda: [0, 0]), set(), deque(), known
        self.former = SimpleNamespace(flags=Fresh(MAP_28_fresh_flag), beside=Fresh(MAP_28_fresh_beside), signs=Fresh(MAP_28_fresh_sign),
                                      patterns=Fresh(MAP_28_fresh_pattern))
        self.GRD_7_grow()

    def GRD_7_grow(self):
        size = [(cells // self.width + 17) // 16 for cells in self.header.cells]  # [GRD-1]
        must(size[0] * size[1] * size[2] < 2**32, "GRD-1", f"{size} bricks")
        self.waiting.extend(self.known.cubes)  # [MAP-28]
        self.seen.update(self.waiting)
        self.bricks.update(map(brick_of, self.waiting))
        self.those_that_wait()
        is_seed, brick_step, place_step, brick, place = CountedBit(), NumberModel(), NumberModel(), 0, 0
        while is_seed.decode(self.coder):
            step = brick_step.decode(self.coder)
            brick, place = (brick + step) % 2**32, 0 if step else place
            place = (place + place_step.decode(self.coder)) % 2**32
            must(place < 4096, "GRD-7", f"place {place}")
            at = brick % size[0], brick // size[0] % size[1], brick // size[0] // size[1]
            must(at[2] < size[2], "GRD-7", f"brick {brick}")
            cube = tuple(16 * b + (place >> 4 * a & 15) for a, b in enumerate(at))
            must(cube not in self.seen, "GRD-7", f"cube {cube} is known")
            self.seen.add(cube)
            self.with_faces(cube)
            self.those_that_wait()

    def those_that_wait(self):  # GRD-7
        while self.waiting:
            cube = self.waiting.popleft()
            if self.GRD_3_flag(cube):
                self.with_faces(cube)

    def flag_model(self, cube):  # GRD-3, MAP-28
        own, (F, E) = [corner_of(cube, i) for i in range(8)], self.without[cube]
        if cube in self.known.cubes:
            return self.former.flags[MAP_28_flag(self.known, self.nodes, own, F)]
        beside = MAP_28_beside(self.known, self.nodes, own, F)
        if beside is not None:
            return self.former.beside[beside]
        return self.flags[64 * sum((node in self.nodes) << i for i, node in enumerate(own)) + 8 * F + min(E, 7)]

    def GRD_3_flag(self, cube):
        if self.flag_model(cube).decode(self.coder):
            return True
        for d in [(x, y, z) for x in (-1, 0, 1) for y in (-1, 0, 1) for z in (-1, 0, 1)]:
            apart = sum(map(abs, d))
            if apart in (1, 2):
                other = tuple(c + x for c, x in zip(cube, d))
                self.without[other][apart - 1] += 1
                self.bricks.add(brick_of(other))  # [GRD-8]
        return False

    def with_faces(self, cube):  # GRD-4 to GRD-8
        """A cube that has faces."""
        signs = self.GRD_4_signs(cube)
        former = MAP_28_pattern(self.known, self.nodes, [corner_of(cube, i) for i in range(8)])
        is_former = former is not None and self.former.patterns[former].decode(self.coder)
        pattern = sorted(self.known.cubes[cube][:15]) if is_former else self.patterns.GRD_5_pattern(self.coder, signs)
        used, numbers = sorted({e for triangle in pattern for e in triangle}), {}
        for e in used:  # [GRD-8]
            numbers[e] = self.count if e == INSIDE else self.edges.setdefault(edge_of(cube, e), self.count)
            self.count += numbers[e] == self.count
        self.faces += [tuple(numbers[e] for e in triangle) for triangle in pattern]
        if INSIDE in used:  # [GRD-6]
            offset = [self.coder.raw(bits(self.width - 1)) for _ in range(3)]
            must(max(offset) < self.width, "GRD-6", f"a vertex at {offset} in its cube")
            self.inner[numbers[INSIDE]] = [self.width * x + q for x, q in zip(cube, offset)]
        n = self.header.geometric
        must(self.count <= n, "GRD-8", "too many vertices")
        must(len(self.faces) <= self.most_faces, "GRD-8", "too many faces")
        must(len(self.bricks) <= min(64 + (n + self.known.count) // 16, 2**20 - 64), "GRD-8", "too many bricks")
        for axis in range(3):  # [GRD-7]
            for high in (0, 1):
                other = moved(cube, axis, 2 * high - 1)
                if 0 < sum(signs >> i & 1 for i in FACES[2 * axis + high]) < 4:
                    self.bricks.add(brick_of(other))
                    if other not in self.seen:
                        self.seen.add(other)
                        self.waiting.append(other)

    def GRD_4_signs(self, cube):
        self.bricks.add(brick_of(cube))
        own = [corner_of(cube, i) for i in range(8)]
        for j in range(8):
            if own[j] in self.nodes:
                continue
            T = sum((1 + self.nodes[own[j ^ t]]) * 3**(t - 1) for t in range(1, 8) if own[j ^ t] in self.nodes)
            around = [tuple(c + d for c, d in zip(own[j], (x, y, z))) for x in (-1, 0, 1) for y in (-1, 0, 1) for z in (-1, 0, 1)]
            sides = [self.nodes[node] for node in around if node in self.nodes and node not in own]
            M = 1 + clamp(2 * sum(sides) - len(sides), -1, 1)
            model = self.former.signs[MAP_28_sign(self.known, self.nodes, own, j, M)] if own[j] in self.known.states else self.signs[3 * T + M]
            self.nodes[own[j]] = model.decode(self.coder)
            self.bricks.add(brick_of(own[j]))
        return sum(self.nodes[corner] << i for i, corner in enumerate(own))

class Levels:
    """[GRD-9, GRD-10] Where vertices are on their edges: `rows`."""
    def __init__(self, coder, header, surface, states):
        self.nodes, self.levels, self.rows, self.cuts, known = surface.nodes, header.levels, {}, {}, surface.known
        g = max(bits(self.levels - 1) - 4, 0)
        fresh = Mixture(even_weights(16))
        fresh.models = Fresh(GRD_10_fresh(((self.levels - 1) >> g) + 1))
        models, former = states.models(("levels", self.levels), places=fresh).places, FormerLevels(known, self.levels, g)
        def place(edge):
            (x, y, z), (bx, by, bz) = edge[1], brick_of(edge[1])
            return bz, by, bx, z, y, edge[0], x
        for k, r in sorted(surface.edges, key=place):  # [GRD-9]
            level = 0
            if self.levels > 1:
                contexts, level = self.GRD_10_contexts(k, r), None
                if (k, r) in known.levels:  # [MAP-29]
                    symbol, level = former.decode(coder, (k, r), self.nodes[r], self.cuts, contexts[1])
                else:
                    symbol = coder.symbol(*models.of(*contexts))
                if level is None:
                    level = symbol << g | coder.raw(g) if g else symbol
                must(level < self.levels, "GRD-9", f"level {level}")
                level = self.levels - 1 - level if self.nodes[r] else level
            self.cuts[k, r] = 32 * (2 * level + 1) // self.levels - 32
            row = [2 * self.levels * x + (2 * level + 1) * (a == k) for a, x in enumerate(r)]
            must(all(0 <= q <= most for q, most in zip(row, header.cells)), "GRD-9", f"coordinates {row}")
            self.rows[surface.edges[k, r]] = row

    def GRD_10_column(self, k, r, d):
        """The height of the column at a step d, and whether it is known."""
        at = tuple(x + y for x, y in zip(r, d))
        s = [self.nodes.get(moved(at, k, by)) for by in (-1, 0, 1, 2)]
        F, height, cut = self.nodes[r], 0, None
        L = 1 - F
        if s[1:3] == [F, L]:
            cut = 0
        elif s[1:3] == [F, F]:
            height, cut = (64, 1) if s[3] == L else (58 if s[3] is None else 108, None)
        elif s[1:3] == [L, L]:
            height, cut = (-64, -1) if s[0] == F else (-58 if s[0] is None else -108, None)
        place = None if cut is None else self.cuts.get((k, moved(at, k, cut)))
        return height + (place or 0), place is not None

    def GRD_10_end(self, k, e):
        """Distance and kind of an edge's end at the node e, and whether the distance is known."""
        distances, is_cut = [], False
        for axis in {0, 1, 2} - {k}:
            for first, other in ((e, moved(e, axis, 1)), (moved(e, axis, -1), moved(e, axis, -1))):
                if self.nodes.get(other) == 1 - self.nodes[e]:
                    is_cut, cut = True, self.cuts.get((axis, first))
                    distances += [] if cut is None else [32 + (cut if first == e else -cut)]
        distance = (sum(distances) * ONE_OVER[len(distances)]) >> 8
        return distance, 2 + min(5, 6 * distance // 64) if distances else int(is_cut), bool(distances)

    def GRD_10_contexts(self, k, r):
        """The two models and the set of weights."""
        a, b = (k + 1) % 3, (k + 2) % 3
        def column(along_a, along_b):
            return self.GRD_10_column(k, r, [along_a * (i == a) + along_b * (i == b) for i in range(3)])
        sides = W, E, N, S = column(-1, 0), column(1, 0), column(0, -1), column(0, 1)
        mean = sum(height * (3 if known else 1) for height, known in sides) >> 3
        turn = 1 if a < b else -1
        guesses = [[(2, W), (-1, column(-2, 0))], [(2, N), (-1, column(0, -2))], [(1, W), (1, N), (-1, column(-1, -1))],
                   [(1, column(turn, -turn)), (turn, W), (-turn, N)]]
        known = [sum(by * height for by, (height, _) in terms) for terms in guesses if all(is_known for _, (_, is_known) in terms)]
        smooth = (sum(known) * ONE_OVER[len(known)]) >> 8
        span = max(known) - min(known) if known else 0
        spread = 0 if len(known) < 2 else 1 + (span >= 10) + (span >= 40)
        first, last = self.GRD_10_end(k, r), self.GRD_10_end(k, moved(r, k, 1))
        if self.nodes[r]:
            mean, smooth, first, last = -mean, -smooth, last, first
        line = mean
        if first[2] or last[2]:
            line = (mean + (((first[0] if first[2] else 32) - (last[0] if last[2] else 32)) >> 1)) >> 1
        c = 1 + clamp((smooth + 40) >> 2, 0, 19) if known else 0
        return ((8 * first[1] + last[1]) * 6 + clamp((mean + 48) >> 4, 0, 5),
                (4 * c + spread) * 6 + clamp((line + 24) >> 3, 0, 5), 4 * (first[2] + 2 * last[2]) + spread)

class Rest:
    """[GRD-11] `faces` in no cube; coordinates of vertices that are not the surface's, `added`. Places are nodes with kinds."""
    INSIDE, FREE = 3, 4

    def __init__(self, coder, chunk, header, surface, rows, count):
        self.coder, self.rows, self.places, numbers, self.added = coder, rows, [], [], []
        self.at = {v: (node, axis) for (axis, node), v in surface.edges.items()}
        self.at |= {v: (tuple(q // surface.width for q in row), self.INSIDE) for v, row in surface.inner.items()}
        self.vertices, self.last = {place: v for v, place in self.at.items()}, 0
        faces = CONN_8_faces(chunk, *count, States())
        self.known, is_shared = POSN_3_known(faces, count[1]), [CountedBit() for _ in range(4)]
        self.number, self.kinds, self.steps = NumberModel(), [even_model(4) for _ in range(5)], defaultdict(NumberModel)
        field = PredictedCoder(coder, self.known, POSN_8_table(coder), header.cells, coder.raw(1))
        for v, known in enumerate(self.known):
            free = [self.places[u][1] == self.FREE for u in known.faces[0][:2]] if known.faces else []
            if is_shared[1 + sum(free) if free else 0].decode(coder):
                number = self.told_by_step(self.places[known.faces[0][0]], header) if free else self.told_by_number()
                field.rows[v], field.sizes[v], field.residuals[v] = rows[number], [0] * 3, [0] * 3
                self.places.append(self.at[number])
            else:
                number = len(rows) + len(self.added)
                self.added.append(field.decode(v))
                self.places.append((tuple(q // surface.width for q in field.rows[v]), self.FREE))
            numbers.append(number)
        self.faces = [tuple(numbers[v] for v in face) for face in faces]

    def told_by_number(self):
        self.last = (self.last + unzigzag(self.number.decode(self.coder))) % 2**32
        must(self.last < len(self.rows), "GRD-11", f"vertex {self.last}")
        return self.last

    def told_by_step(self, near, header):
        kind = self.coder.symbol([self.kinds[near[1]]])
        node = tuple(x + unzigzag(self.steps[near[1], kind, axis].decode(self.coder)) for axis, x in enumerate(near[0]))
        must(all(0 <= x <= most for x, most in zip(node, header.cells)), "GRD-11", f"node {node}")
        must((node, kind) in self.vertices, "GRD-11", f"the surface has no vertex of kind {kind} at {node}")
        return self.vertices[node, kind]

def GRD_12_read(chunks, header, states, known=None):
    """Faces and positions of the geometric vertices, in doubles."""
    coder = Coder(chunks["GRID"])
    count = NumberModel().decode(coder), NumberModel().decode(coder)
    must(count[0] <= header.triangles, "GRD-8", f"{count[0]} faces of the rest")
    must(count[1] <= 3 * count[0] + header.geometric, "GRD-8", f"{count[1]} vertices of the rest")
    must(count[1] or not (count[0] or chunks["CONN"].data), "GRD-11", "a rest without vertices")
    surface = Surface(coder, header, header.triangles - count[0], states, known or NothingKnown)
    rows, faces = Levels(coder, header, surface, states).rows | surface.inner, surface.faces
    inner = surface.inner.values()
    must(all(0 <= q <= most for row in inner for q, most in zip(row, header.cells)), "GRD-9", "a vertex beyond the lattice")
    debug("grid: nodes %s\nfaces %s\nlattice points %s", surface.nodes, faces, rows)
    rest = Rest(coder, chunks["CONN"], header, surface, rows, count) if count[1] else None
    faces, added = (faces + rest.faces, rest.added) if rest else (faces, [])
    chunks["GRID"].end()
    must(len(faces) == header.triangles, "GRD-8", f"{len(faces)} faces")
    must(len(rows) + len(added) == header.geometric, "GRD-8", f"{len(rows) + len(added)} vertices")
    return faces, POSN_2_positions([rows[v] for v in range(len(rows))] + added, header)
