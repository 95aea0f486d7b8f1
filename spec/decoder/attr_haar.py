"""Colours and numbers by a transform over the mesh: attr_haar.md, HAAR-1 to HAAR-15."""
import math

import numpy as np

from attr_colors import ATTR_46_value
from coder import Coder, Fresh, ScaledCoder, SymbolModel, bits, clamp
from container import must
from graph import neighbours

def HAAR_1_log(k, x):
    octave = bits(x) - 1
    return (octave << k) + ((x << k >> octave) & (2**k - 1))

def HAAR_2_places(positions, n):
    if positions is None:
        return [(0, 0, 0)] * n
    rows = np.array(positions, dtype="f8").reshape(n, 3)
    finite = [column[np.isfinite(column)] for column in rows.T]
    low = [min(column, default=0.0) for column in finite]
    extent = max(max(column, default=0.0) - least for column, least in zip(finite, low))
    if extent == 0:
        return [(0, 0, 0)] * n
    scale = 2.0**(20 - math.frexp(extent)[1])
    return [tuple(math.floor((x - least) * scale) if math.isfinite(x) else 0 for x, least in zip(row, low)) for row in rows]

def squared(a, b):  # HAAR-4, HAAR-8
    return sum((x - y)**2 for x, y in zip(a, b))

class Level:
    """[HAAR-3, HAAR-5] `children`: of each node in the finer level, one or two; `g`: of each pair."""
    def __init__(self, places, weights, lists, children=(), g=()):
        self.places, self.weights, self.lists, self.children, self.g = places, weights, lists, children, g

def HAAR_3_levels(surface):
    """All levels, the vertices first."""
    geometric, lists = surface.geometric, []
    for v, around in enumerate(neighbours(surface.faces, surface.n)):
        copies = [u for u in (v - 1, v + 1) if 0 <= u < surface.n and geometric[u] == geometric[v]]
        lists.append((copies + around)[:16])
    levels = [Level(HAAR_2_places(surface.positions, surface.n), [1] * surface.n, lists)]
    while len(levels[-1].weights) > 1:
        levels.append(HAAR_5_next(levels[-1], HAAR_4_mates(levels[-1])))
    return levels

def HAAR_4_mates(level):
    """What each node is joined with; itself if with none."""
    count = len(level.weights)
    mates, waiting, isolated = list(range(count)), {}, []

    def cost(i, j):
        return HAAR_1_log(8, squared(level.places[i], level.places[j]) + 1) + HAAR_1_log(8, level.weights[i] + level.weights[j])
    def choice(i):
        return min((j for j in level.lists[i] if mates[j] == j), key=lambda j: cost(i, j), default=None)
    def join(i, j):
        mates[i], mates[j] = j, i

    for _ in range(2):
        choices = {i: choice(i) for i in range(count) if mates[i] == i}
        for i, j in choices.items():
            if j is not None and i < j and choices[j] == i:
                join(i, j)
    for i in range(count):
        if mates[i] == i and (j := choice(i)) is not None:
            join(i, j)
    for i in range(count):
        if mates[i] == i and level.lists[i]:
            b = min(level.lists[i], key=lambda j: cost(i, j))
            if b in waiting:
                join(waiting.pop(b), i)
            else:
                waiting[b] = i
    for i in range(count):
        if mates[i] == i and not level.lists[i]:
            isolated.append((sum((x >> k & 1) << (3 * k + a) for a, x in enumerate(level.places[i]) for k in range(20)), i))
    isolated.sort()
    for (_, i), (_, j) in zip(isolated[::2], isolated[1::2]):
        join(i, j)
    return mates

def HAAR_5_next(fine, mates):
    children = [(i,) if j == i else (i, j) for i, j in enumerate(mates) if j >= i]
    parents = {child: i for i, pair in enumerate(children) for child in pair}
    places, weights, lists, g = [], [], [], []
    for i, pair in enumerate(children):
        first, last = pair[0], pair[-1]
        weights.append(sum(fine.weights[child] for child in pair))
        g.append((fine.weights[first] << 16) // weights[i])
        ways = [p - q for p, q in zip(fine.places[first], fine.places[last])]
        places.append(tuple(q + (way * g[i] >> 16) for q, way in zip(fine.places[last], ways)))
        around = dict.fromkeys(parents[u] for child in pair for u in fine.lists[child])
        lists.append([u for u in around if u != i][:16])
    return Level(places, weights, lists, children, g)

def HAAR_6_values(r, a, surface):
    """Rows of red, green and blue, and alpha; or of a number."""
    axes, alpha, level, low, unit = 1, 0, None, 0.0, 1.0
    if a.k == 1:
        low, unit = r.number("f"), r.number("f")
        must(math.isfinite(low), "HAAR-6", f"low {low}")
        must(0 < unit < math.inf, "HAAR-6", f"unit {unit}")
    else:
        axes = r.u8()
        must(axes in (1, 3), "HAAR-6", f"{axes} axes")
    if a.k == 4:
        alpha = r.u8()
        must(alpha in (1, 2), "HAAR-6", f"alpha {alpha}")
        level = r.u8() if alpha == 1 else None
    step = r.number("H")
    must(step >= 1, "HAAR-6", "step 0")
    if surface.n == 0:
        return []
    coder, levels = Coder(r), HAAR_3_levels(surface)
    learnt = surface.states.models(("coefficients", surface.attributes.index(a)), numbers=fresh_numbers())  # [CMP-16]
    values = HaarCoder(coder, levels, axes, step, learnt.numbers).decode()
    if a.k == 1:
        return [[HAAR_15_number(value[0], low, unit, a.type)] for value in values]
    rows = [HAAR_14_colour(value) for value in values]
    if alpha == 1:
        rows = [row + [level] for row in rows]
    if alpha == 2:
        rows = [row + HAAR_14_colour(value)[:1] for row, value in zip(rows, HaarCoder(coder, levels, 1, step, fresh_numbers()).decode())]
    return [[ATTR_46_value(x, a.type, 8) for x in row] for row in rows]

class HaarCoder:  # HAAR-7 to HAAR-13
    def __init__(self, coder, levels, axes, step, numbers):
        self.coder, self.levels, self.axes, self.step, self.numbers = coder, levels, range(axes), step, numbers

    def decode(self):
        """[HAAR-7] The values of the vertices. Known of a node: place, value, sizes."""
        value = [self.coder.raw(15) - 8192 for _ in self.axes]
        known = [(self.levels[-1].places[0], value, [0 for _ in self.axes])]
        for fine, level in zip(self.levels[-2::-1], self.levels[:0:-1]):
            finer = {child: known[i] for i, pair in enumerate(level.children) for child in pair}
            for i, pair in enumerate(level.children):
                if len(pair) == 2:
                    self.split(fine, pair, level.g[i], known[i], finer)
            known = [finer[i] for i in range(len(fine.weights))]
        return [value for _, value, _ in known]

    def HAAR_8_shares(self, fine, child, sibling, finer):
        """Neighbours with their shares."""
        unit = HAAR_1_log(4, max(squared(fine.places[child], fine.places[sibling]), 1))
        for u in fine.lists[child]:
            if u != sibling:
                d = max(squared(finer[u][0], fine.places[child]), 1)
                i = clamp(HAAR_1_log(4, d) - unit + 64, 0, 127)
                yield u, 2**23 // (((16 + i % 16) << (i // 16)) + 192)**2

    def HAAR_9_around(self, t, near, parent, finer):
        """E, spread, around of axis t; `near`: the neighbours with their shares of each child."""
        s = [sum(share for _, share in shares) for shares in near]
        ways = [[(share, finer[u][1][t] - parent[1][t]) for u, share in shares] for shares in near]
        V = [sum(share * way for share, way in of) for of in ways]
        E = 182 * (V[0] * (2**26 // (s[0] + 38)) - V[1] * (2**26 // (s[1] + 38))) >> 34
        if sum(s) == 0:
            return E, 0, parent[2][t]
        A, R = sum(share * abs(way) for of in ways for share, way in of), 2**26 // sum(s)
        Z = sum(share * finer[u][2][t] for shares in near for u, share in shares)
        return E, A * R >> 26, Z * R >> 26

    def split(self, fine, pair, g, parent, finer):
        """[HAAR-10, HAAR-13] Adds what is known of the two."""
        w, coded = [fine.weights[child] for child in pair], 0
        near = [list(self.HAAR_8_shares(fine, child, other, finer)) for child, other in (pair, pair[::-1])]
        f = max(1, math.isqrt(self.step**2 * sum(w) // (w[0] * w[1])))
        values, sizes = ([], []), []
        for t in self.axes:
            E, spread, around = self.HAAR_9_around(t, near, parent, finer)
            size = (166 * around + 90 * parent[2][t]) >> 8
            q = self.HAAR_11_number(t, size, spread * (2**20 // f) >> 16, coded, sum(w))
            q_size = 16 * min(abs(q), 2047)
            coded = q_size if t == 0 else (coded + q_size) >> 1
            x = clamp(E + q * f, -2**16, 2**16)
            low = parent[1][t] - (x * g >> 16)
            for of, value in zip(values, (low + x, low)):
                of.append(clamp(value, -8192, 24575))
            sizes.append((5 * q_size + 3 * size) >> 3)
        for child, value in zip(pair, values):
            finer[child] = fine.places[child], value, sizes

    def HAAR_11_number(self, t, size, S, coded, weight):
        expected = (133 * size + 58 * S + 30 * coded) >> 8
        shift = max(bits(expected) - 6, 0)
        def K(x):
            return HAAR_1_log(2, x + 2) - 4
        def B(x):
            return min(max(K(x) - 4 * shift, 0) // 2, 11)
        k, c = K(expected >> shift) + (5 if shift else 0), 0 if weight <= 2 else 1 if weight <= 8 else 2
        q = self.numbers.CMP_15_number(self.coder, (3 * k + c) * 3 + t, (12 * B(S) + B(coded)) * 3 + t, 3 * (k // 4) + t, shift)
        return clamp(q, -2**16, 2**16)

def fresh_numbers():  # HAAR-12
    numbers = ScaledCoder()
    numbers.models = Fresh(HAAR_12_fresh)
    return numbers

def HAAR_12_fresh(key):
    """The model of a table and number."""
    table, number = key
    j, x = number // 9 if table == 0 else 2 * (number // 36), [200]
    m = ((4 + j % 4) << (j // 4)) - 3
    while len(x) < 8:
        x.append(max(x[-1] * m // (m + 12), 1))
    return SymbolModel([x[abs(s - 7)] for s in range(15)] + [x[7]])

def HAAR_15_number(Y, low, unit, type_):
    x = low + unit * Y / 64
    if type_ == "f4":
        return np.float32(x)
    return clamp(math.floor(x + 0.5), 0, np.iinfo(type_).max)

def HAAR_14_colour(value):
    Y, B, R = (value + [0, 0])[:3]
    sums = (22970 * R, -5638 * B - 11700 * R, 29032 * B)
    return [clamp((16384 * Y + x + 2**19) >> 20, 0, 255) for x in sums]
