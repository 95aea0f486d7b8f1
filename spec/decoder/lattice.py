"""POSN-3 to POSN-9: what is expected of a vertex' numbers, and their coding."""
import numpy as np

from coder import BitModel, Mixture, ScaledCoder, States, bits, clamp, log4
from container import must
from graph import corners

class Known:
    """[POSN-3] The known faces of a vertex as triples (a, b, o or None), its neighbours, and how many faces are at it."""
    def __init__(self, faces, count):
        self.faces, self.count, self.parallelograms = faces, count, [face for face in faces if face[2] is not None]
        self.neighbours = [b for _, b, _ in faces] + [a for a, _, _ in faces if all(a != b for _, b, _ in faces)]
        self.corners = [u for a, b, _ in faces for u in (a, b)]
        self.sources = min(len(self.parallelograms), 3) + 1 if self.parallelograms else int(bool(faces))  # [POSN-5]

def POSN_3_other(faces, low):
    """The corner across the edge from a vertex with these known faces to the vertex `low`, or None."""
    return next((y if x == low else x for x, y, _ in faces if low in (x, y)), None)

def POSN_3_known(faces, n):
    """Of every vertex."""
    at, result = corners(faces, n), []
    for v in range(n):
        pairs = [(a, b) for _, a, b in at[v] if max(a, b) < v and a != b][:4]
        known = [(a, b, POSN_3_other(result[max(a, b)].faces, min(a, b))) for a, b in pairs]
        result.append(Known(known, len(at[v])))
    return result

def POSN_4_mean(numbers):
    c = len(numbers)
    return (sum(numbers) * ((65536 + c // 2) // c)) >> 16

def POSN_8_table(coder):
    """The blend table as rows (U, V)."""
    differs, rows = BitModel(), []
    for row in range(24):
        U, V = (45, 55, 50, 45)[row // 6], 0
        if differs.decode(coder):
            U, V = (coder.raw(8) ^ 128) - 128, (coder.raw(8) ^ 128) - 128
        rows.append((U, V))
    return rows

def POSN_4_expect(known, table, number, before):
    """Place and spread on an axis; `number(u)` is the number of vertex u, `before` that of the vertex before."""
    place, spread = 16 * before, 0
    if known.faces:
        base = number(known.faces[0][0])
        def q(u):
            return number(u) - base
        N = POSN_4_mean([16 * q(u) for u in known.neighbours])
        place, spread = 16 * base + N, POSN_4_mean([abs(16 * q(u) - N) for u in known.corners])
    if known.parallelograms:
        guesses = [16 * (q(a) + q(b) - q(o)) for a, b, o in known.parallelograms]
        P, E = POSN_4_mean(guesses), POSN_4_mean([8 * (q(a) + q(b)) for a, b, _ in known.parallelograms])
        U, V = table[6 * (len(guesses) - 1) + clamp(known.count, 3, 8) - 3]
        place, spread = place + ((U * (P - N) + V * (E - N)) >> 6), POSN_4_mean([abs(g - P) for g in guesses])
    return clamp(place >> 4, -2**30, 2**30) * 16 + (place & 15), min(spread, 2**30)

def POSN_2_positions(rows, header):
    return np.array([[header.POSN_2_place(a, q) for a, q in enumerate(rows[v])] for v in range(len(rows))])

class Context:
    """[POSN-5] What the coding of a number depends on; `off` are the numbers of the axes before, less their `whole`."""
    def __init__(self, axis, expected, sizes, residual, sources, off, whole, missed):
        self.axis, (place, self.spread), self.sources, self.whole, self.missed = axis, expected, sources, whole, missed
        seen = [min(16 * abs(x), 2**26) for x in off]
        coded = 0 if axis == 0 else seen[0] if axis == 1 else (seen[0] + seen[1]) >> 1
        scale = (5 * sizes[axis] + 3 * (sum(sizes) // 3)) >> 3
        scale = (scale + self.spread) >> 1 if sources > 2 else max(scale, self.spread) if sources < 2 else scale
        self.scale = min(scale + 1, 2**24 - 1)
        self.mean = place - 16 * ((place + 8) >> 4) - (residual >> 2)
        self.shift = max(bits(self.scale) - 6, 0)
        self.sure = 0 if axis == 0 else 1 if 4 * coded < self.scale else 2 if coded >= 2 * self.scale else 0
        if self.shift == 0:
            self.sure = min(abs(self.mean), 8) // 2

class PredictedCoder:
    """[POSN-4 to POSN-6, FLT-4] Numbers of vertices. What is said below of lattices, other coders say of theirs."""
    rule = "POSN-7"  # that a number out of its limits breaks

    def __init__(self, coder, known, table, cells, guesses=False, states=None):
        self.coder, self.known, self.table, self.guesses = coder, known, table, guesses
        self.limits = [(0, most) for most in cells]
        self.rows, self.residuals, self.sizes = {}, {}, {}
        self.learnt = (states or States()).models(type(self), numbers=ScaledCoder(), guesses=Mixture((8, 4, 2, 2) + (1,) * 12))

    def row(self, u, v):  # POSN-4, ATTR-64
        """The numbers of u that the expectation for v is made of."""
        return self.rows[u]

    def before(self, v):  # POSN-4
        return [0] * len(self.limits) if v == 0 else self.row(v - 1, v)

    def read(self, v, x):  # POSN-6, POSN-9
        """The number of a vertex on an axis."""
        known, values = self.known[v], []
        if self.guesses:  # [POSN-9]
            def q(u):
                return self.rows[u][x.axis]
            values = [g for a, b, o in known.parallelograms if 0 <= (g := q(a) + q(b) - q(o)) <= self.limits[x.axis][1]]
            values += [q(u) for u in known.corners]
        guess = self.FLT_4_guess(known, x, values, x.whole)
        return x.whole + self.POSN_6_number(x) if guess is None else guess

    def kept(self, v):
        """[POSN-5] G and R"""
        def mean(of):
            sums = [[of[a][i] + of[b][i] for a, b, _ in self.known[v].faces[:2]] for i in range(len(self.limits))]
            return [sum(s) >> len(s) for s in sums]
        return mean(self.sizes), mean(self.residuals)

    def vertex(self, v):  # POSN-4, POSN-5, POSN-7
        """A generator that decodes one number of vertex v at each step."""
        known, (G, R), before, off, missed = self.known[v], self.kept(v), self.before(v), [], set()
        self.rows[v], self.sizes[v], self.residuals[v] = [], [], []
        for a, limits in enumerate(self.limits):
            expected = POSN_4_expect(known, self.table, lambda u: self.row(u, v)[a], before[a])
            x = Context(a, expected, G, R[a], known.sources, off, clamp((expected[0] + 8) >> 4, *limits), missed)
            q = self.read(v, x)
            must(limits[0] <= q <= limits[1], self.rule, f"number {q} of vertex {v}")
            self.rows[v].append(q)
            off.append(q - x.whole)
            e = clamp(16 * q - expected[0], -2**26, 2**26)
            self.residuals[v].append(e)
            self.sizes[v].append((5 * abs(e) + 3 * G[a]) >> 3 if known.sources else abs(e))
            yield

    def decode(self, v):  # POSN-13, ATTR-57
        """All numbers of vertex v."""
        list(self.vertex(v))
        return self.rows[v]

    def POSN_6_number(self, x, shift=None):
        """The number less what is expected; `shift` in place of the context's in the coding, not in the indices."""
        t, S = log4(clamp(x.spread, 1, 2**24 - 1)) - 4 * x.shift, log4(x.scale) - 4 * x.shift
        S = S if x.shift else max(S >> 1, S - 4)
        T = clamp(max((t + 2) >> 1, t - 3), 0, 23) if x.spread else 0
        first, second, weights = (S * 5 + x.sources) * 5 + x.sure, (T * 5 + x.sources) * 3 + x.axis, x.axis * 5 + x.sources
        number = self.learnt.numbers.CMP_15_number(self.coder, first, second, weights, x.shift if shift is None else shift)
        return -number if x.mean < 0 else number

    def FLT_4_guess(self, known, x, values, expected):
        """Which of a few values the number is, or None."""
        different = sorted(list(dict.fromkeys(values))[:6], key=lambda value: abs(value - expected))
        M, V = (0 in x.missed) + 2 * (1 in x.missed), len(different)
        if V:
            H = (0, 1 + M, 3 + M)[x.axis]
            second = (min(len(known.parallelograms), 4) * 7 + H) * 7 + min(known.count, 6)
            s = self.coder.symbol(*self.learnt.guesses.of((x.axis * 4 + M) * 7 + V, second, 0))
            if 1 <= s <= V:
                return different[s - 1]
        x.missed.add(x.axis)
        return None
