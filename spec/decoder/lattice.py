"""POSN-3 to POSN-9: what is expected of a vertex' numbers, and their coding."""
from coder import BitModel, bits, clamp, mixing_weights, symbol_models
from container import must
from graph import corners, others
from scaled import SYMBOL_WEIGHTS, ScaledCoder

class Known:
    """[POSN-3] The known faces of a vertex as triples (a, b, o or None), its neighbours, and how many faces are at it."""
    def __init__(self, faces, count):
        self.faces, self.count = faces, count
        self.neighbours = [b for _, b, _ in faces] + [a for a, _, _ in faces if all(a != b for _, b, _ in faces)]
        self.parallelograms = [face for face in faces if face[2] is not None]

    @property
    def sources(self):
        """[POSN-5]"""
        c = len(self.parallelograms)
        return min(c, 3) + 1 if c else int(bool(self.faces))

def POSN_3_known(faces, n):
    at, result = corners(faces, n), []
    for v in range(n):
        found = []
        for corner in at[v]:
            a, b = others(faces, corner)
            if a < v and b < v and a != b and len(found) < 4:
                low, high = min(a, b), max(a, b)
                third = next((y if x == low else x for x, y, _ in result[high].faces if low in (x, y)), None)
                found.append((a, b, third))
        result.append(Known(found, len(at[v])))
    return result

def POSN_4_mean(numbers):
    c = len(numbers)
    return (sum(numbers) * ((65536 + c // 2) // c)) >> 16

def POSN_8_table(coder):
    """The blend table as rows (A, C)."""
    differs, rows = BitModel(), []
    for row in range(24):
        A, C = (45, 55, 50, 45)[row // 6], 0
        if differs.decode(coder):
            A, C = (coder.raw(8) ^ 128) - 128, (coder.raw(8) ^ 128) - 128
        rows.append((A, C))
    return rows

def POSN_4_expect(known, table, row, axis, before):
    """Place and spread on an axis; `row(u)` are the numbers of vertex u, `before` the number of the vertex before."""
    if not known.faces:
        return POSN_4_limit(16 * before, 0)
    base = row(known.faces[0][0])[axis]
    def q(u):
        return row(u)[axis] - base
    N = POSN_4_mean([16 * q(u) for u in known.neighbours])
    if not known.parallelograms:
        return POSN_4_limit(16 * base + N, POSN_4_mean([abs(16 * q(u) - N) for a, b, _ in known.faces for u in (a, b)]))
    guesses = [16 * (q(a) + q(b) - q(o)) for a, b, o in known.parallelograms]
    P, E = POSN_4_mean(guesses), POSN_4_mean([8 * (q(a) + q(b)) for a, b, _ in known.parallelograms])
    A, C = table[6 * (len(guesses) - 1) + clamp(known.count, 3, 8) - 3]
    place = 16 * base + N + ((A * (P - N) + C * (E - N)) >> 6)
    return POSN_4_limit(place, POSN_4_mean([abs(g - P) for g in guesses]))

def POSN_4_limit(place, spread):
    return clamp(place >> 4, -2**30, 2**30) * 16 + (place & 15), min(spread, 2**30)

class Context:
    """[POSN-5] What the coding of a number depends on."""
    def __init__(self, axis, place, spread, sizes, residual, sources, coded, whole):
        self.axis, self.place, self.spread, self.sources, self.whole = axis, place, spread, sources, whole
        scale = (5 * sizes[axis] + 3 * (sum(sizes) // 3)) >> 3
        if sources > 2:
            scale = (scale + spread) >> 1
        elif sources < 2:
            scale = max(scale, spread)
        self.scale = min(scale + 1, 2**24 - 1)
        self.mean = place - 16 * ((place + 8) >> 4) - (residual >> 2)
        self.shift = max(bits(self.scale) - 6, 0)
        if self.shift == 0:
            self.sure = min(abs(self.mean), 8) // 2
        else:
            self.sure = 0 if axis == 0 else 1 if 4 * coded < self.scale else 2 if coded >= 2 * self.scale else 0

class Kept:
    """[POSN-5] Residuals and magnitudes of the vertices coded so far."""
    def __init__(self):
        self.residuals, self.sizes = {}, {}

    def sums(self, faces):
        """G and R, of the first two of these faces."""
        def mean(of):
            sums = [[of[a][i] + of[b][i] for a, b, _ in faces[:2]] for i in range(3)]
            return [sum(s) >> len(s) for s in sums]
        return mean(self.sizes), mean(self.residuals)

    def keep(self, v, numbers, places, sources, sizes):
        e = [clamp(16 * q - place, -2**26, 2**26) for q, place in zip(numbers, places)]
        self.residuals[v] = e
        self.sizes[v] = [(5 * abs(x) + 3 * G) >> 3 if sources else abs(x) for x, G in zip(e, sizes)]

    def keep_nothing(self, v):
        self.residuals[v] = self.sizes[v] = [0, 0, 0]

def POSN_5_coded(axis, off):
    """`off` are the differences of the numbers before to what was expected of them."""
    sizes = [min(16 * abs(x), 2**26) for x in off]
    return 0 if axis == 0 else sizes[0] if axis == 1 else min((sizes[0] + sizes[1]) >> 1, 2**26)

def POSN_6_log(y):
    """W"""
    return 4 * (bits(y) - 1) + ((4 * y >> (bits(y) - 1)) & 3)

class NumberCoder:
    """[POSN-6]"""
    def __init__(self):
        self.scaled, self.weights = ScaledCoder(), mixing_weights(2)
        self.models = symbol_models(SYMBOL_WEIGHTS)

    def decode(self, coder, x, shift=None):
        """The number less what is expected; `shift` in place of the context's in the coding, not in the indices."""
        t, S = POSN_6_log(max(min(x.spread, 2**24 - 1), 1)) - 4 * x.shift, POSN_6_log(x.scale) - 4 * x.shift
        if x.shift == 0:
            S = max(POSN_6_log(x.scale) >> 1, POSN_6_log(x.scale) - 4)
        T = clamp(max((t + 2) >> 1, t - 3), 0, 23) if x.spread else 0
        models = [self.models[0, (S * 5 + x.sources) * 5 + x.sure], self.models[1, (T * 5 + x.sources) * 3 + x.axis]]
        shift = x.shift if shift is None else shift
        number = self.scaled.FLD_5_number(coder, models, self.weights[x.axis * 5 + x.sources], shift,
                                          min(shift, 3) * 5 + x.sources)
        return -number if x.mean < 0 else number

class GuessCoder:
    """[FLT-4, POSN-9] Which of a few values a number is."""
    def __init__(self):
        self.models, self.weights = symbol_models((8, 4, 2, 2) + (1,) * 12), mixing_weights(2)

    def decode(self, coder, axis, values, expected, known, missed):
        """The value, or None; `missed` are the axes before on which it was none of the values."""
        different = list(dict.fromkeys(values))[:6]
        different.sort(key=lambda value: abs(value - expected))
        M, V = (0 in missed) + 2 * (1 in missed), len(different)
        B = 0 if axis == 0 else 1 + M if axis == 1 else 3 + M
        second = (min(len(known.parallelograms), 4) * 7 + B) * 7 + min(known.count, 6)
        s = coder.symbol([self.models[0, (axis * 4 + M) * 7 + V], self.models[1, second]], self.weights[0])
        return different[s - 1] if 1 <= s <= V else None

class LatticeCoder:
    """[POSN-3 to POSN-9] Numbers of vertices, one vertex after the other or two in turns."""
    def __init__(self, coder, known, table, cells, guesses):
        self.coder, self.known, self.table, self.cells, self.guesses = coder, known, table, cells, guesses
        self.rows, self.kept = {}, Kept()
        self.numbers, self.guess = NumberCoder(), GuessCoder()

    def vertex(self, v):
        """A generator that decodes one number of vertex v at each step."""
        known = self.known[v]
        G, R = self.kept.sums(known.faces)
        before = self.rows[v - 1] if v else [0, 0, 0]
        self.rows[v] = row = [0, 0, 0]
        off, places, missed = [], [], set()
        for a in range(3):
            place, spread = POSN_4_expect(known, self.table, self.rows.__getitem__, a, before[a])
            places.append(place)
            whole = clamp((place + 8) >> 4, 0, self.cells[a] or 0)
            q = 0 if self.cells[a] is None else self.POSN_9_guess(known, a, whole, missed)  # None: lacking [ATTR-57]
            if q is None:
                x = Context(a, place, spread, G, R[a], known.sources, POSN_5_coded(a, off), whole)
                q = whole + self.numbers.decode(self.coder, x)
            must(0 <= q <= (self.cells[a] or 0), "POSN-7", f"coordinate {q} of vertex {v}")
            row[a] = q
            off.append(q - whole)
            if a == 2:
                self.kept.keep(v, row, places, known.sources, G)
            yield

    def POSN_9_guess(self, known, a, whole, missed):
        if not self.guesses or not known.faces:
            return None
        def q(u):
            return self.rows[u][a]
        values = [q(x) + q(y) - q(o) for x, y, o in known.parallelograms]
        values = [g for g in values if 0 <= g <= self.cells[a]] + [q(u) for x, y, _ in known.faces for u in (x, y)]
        guess = self.guess.decode(self.coder, a, values, whole, known, missed)
        if guess is None:
            missed.add(a)
        return guess
