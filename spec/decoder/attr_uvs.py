"""Texture coordinates off the surface: attr_uvs.md, ATTR-31 to ATTR-37."""
from types import SimpleNamespace

import numpy as np

from coder import Coder
from container import must
from surface_order import ATTR_30_order, BitOfFaces, PairCoder, whole_part
from vectors import F, cross, dot, square

NOTHING = np.zeros(2)

def ATTR_31_uvs(r, a, surface):
    step = r.number("f")
    must(2.0**-100 <= step <= 2.0**64, "ATTR-31", f"step {step}")
    return UvCoder(Coder(r), surface, step).decode()

def solve_symmetric(matrix, right):
    """[ATTR-34]"""
    (a, b, c), (_, e, f), (_, _, i) = matrix
    aa, ab, ac, bb, bc, cc = e * i - f * f, c * f - b * i, b * f - c * e, a * i - c * c, b * c - a * f, a * e - b * b
    determinant = a * aa + b * ab + c * ac
    rows = np.array([[aa, ab, ac], [ab, bb, bc], [ac, bc, cc]])
    return [dot(row, right) * (1 / determinant) if determinant > 0 else 0.0 for row in rows]

class Fit:
    """[ATTR-34] A linear function of a place; U and Q have a part for u and one for v."""
    def __init__(self):
        self.sums = [np.zeros(()), np.zeros(2), np.zeros(3), np.zeros((2, 3)), np.zeros((3, 3))]  # N, U, P, Q, S
        self.number, self.function = 0, None

    def learn(self, p, u, is_first):
        self.number = 0 if is_first else self.number + 1
        if is_first:
            self.sums = [x * (1 / 1024) for x in self.sums]
        if self.number >= 8 and self.number % 4:
            return
        N, U, P, Q, S = self.sums = [x * 0.98 + y for x, y in zip(self.sums, (1, u, p, np.outer(u, p), np.outer(p, p)))]
        h = 1 / N
        M, V = h * P, h * U
        C = h * S - np.outer(M, M)
        C = C + (1e-6 * (C[0, 0] + C[1, 1] + C[2, 2]) + 1e-12) * np.eye(3)
        self.function = M, V, np.array([solve_symmetric(C, h * q - M * value) for q, value in zip(Q, V)])

    def at(self, p):
        M, V, G = self.function
        return V + (p[0] - M[0]) * G[:, 0] + (p[1] - M[1]) * G[:, 1] + (p[2] - M[2]) * G[:, 2]

class Blend:
    """[ATTR-35]"""
    def __init__(self):
        self.X, self.Y = np.zeros((2, 2)), np.zeros(2)

    def correction(self, d1, d2):
        a, c, b, w1, w2 = self.X[0, 0] + 0.02, self.X[1, 1] + 0.02, self.X[0, 1], 0.0, 0.0
        D = a * c - b * b
        if D > 0:
            h = 1 / D
            w1, w2 = h * (c * self.Y[0] - b * self.Y[1]), h * (a * self.Y[1] - b * self.Y[0])
        return w1 * d1 + w2 * d2

    def learn(self, d1, d2, e, g):
        self.X = 0.99 * self.X + g * np.array([[dot(x, y) for y in (d1, d2)] for x in (d1, d2)])
        self.Y = 0.99 * self.Y + g * np.array([dot(x, e) for x in (d1, d2)])

class UvCoder:  # ATTR-31 to ATTR-37
    def __init__(self, coder, surface, step):
        self.surface, self.step, self.values, self.kept, self.side = surface, step, {}, {}, 1.0
        self.blends, self.fit, self.same, self.pairs = [Blend() for _ in range(4)], Fit(), BitOfFaces(coder), PairCoder(coder)
        self.positions = None if surface.positions is None else surface.positions.astype(np.float64)
        if self.positions is not None:
            low, high = self.positions.min(axis=0), self.positions.max(axis=0)
            self.places = (1 / (max(high - low) or 1.0)) * (self.positions - 0.5 * (low + high))

    def decode(self):  # ATTR-31
        last = NOTHING
        for v, completed, around, copy in ATTR_30_order(self.surface):
            prediction = self.ATTR_33_prediction(v, completed, last)
            last = self.values[v] = self.ATTR_37_value(v, around, copy, prediction)
            self.learn(v, completed, prediction)
        return [self.values[v] for v in range(self.surface.n)]

    def ATTR_37_value(self, v, around, copy, prediction):
        """[ATTR-36, ATTR-37]"""
        self.kept[v], n = 0, prediction.n
        if copy is not None and self.same.decode(v, around):
            return self.values[copy]
        near, spread, kind = 4096, 4096, int(prediction.is_linked)
        if n:
            near, spread = sum(self.kept[u] for u in around) // len(around), whole_part(prediction.spread * (16 / self.step))
            kind = 1 + min(n, 3)
        p, q = self.pairs.decode((near, near), (spread, spread), kind)
        must(max(abs(p), abs(q)) <= 2**24, "ATTR-37", f"numbers {p} and {q}")
        self.kept[v] = (5 * min(8 * (abs(p) + abs(q)), 2**17) + 3 * near) >> 3 if n else 0
        limit = 2.0**22 * self.step
        centre = np.where(np.isnan(prediction.value), 0.0, np.clip(prediction.value, -limit, limit))
        return (centre + self.step * np.array([p, q])).astype(F).astype(float)

    def ATTR_32_over(self, a, b, c):
        """x and y of c over the edge from a to b, or None where the face does not count."""
        A, B, C = (self.positions[u] for u in (a, b, c))
        e, w = B - A, C - A
        h = 1 / dot(e, e)
        x = dot(e, w) * h
        return (x, np.sqrt(max(square(w) * h - x * x, 0.0))) if square(w) * h <= 1e6 else None

    def ATTR_32_face(self, v, f, ia, ib):
        """Prediction and weight, the other prediction and weight (None where there is none); None if the face does not count."""
        thirds = (third for g, third, before in self.surface.corners[ia] if g != f and before == ib and third in self.values)
        a, b, across = self.values[ia], self.values[ib], next(thirds, None)
        o, middle = self.values.get(across), 0.5 * (a + b)
        if self.positions is None:
            return ((middle, 0.25) if o is None else (a + b - o, 1.0)), (middle, 1.0)
        own = self.ATTR_32_over(ia, ib, v)
        if own is None:
            return None
        (x, y), E, side, other = own, b - a, self.side, None
        foot, m = a + x * E, 1 / (y + 0.01)
        beyond = None if across is None else self.ATTR_32_over(ia, ib, across)
        if beyond:
            d = cross(E, o - a)
            side = 1.0 if d < 0 else -1.0 if d > 0 else side
            if beyond[1] > 0.05:
                t = y / beyond[1]
                r = min(t, 4.0)
                other = foot + t * ((a + beyond[0] * E) - o), m / (1 + r * r)
        return (foot + (side * y) * np.array([-E[1], E[0]]), m), other

    def ATTR_33_prediction(self, v, completed, last):
        found = [(a, b, self.ATTR_32_face(v, f, a, b)) for f, a, b in completed]
        counting = [(a, b, *predictions) for a, b, predictions in found if predictions]
        if not counting:
            linked = next((self.values[u] for _, *ends in self.surface.corners[v] for u in ends if u in self.values), None)
            return SimpleNamespace(value=last if linked is None else linked, n=0, is_linked=linked is not None)
        def mean(pairs):
            return sum((w * f for f, w in pairs), NOTHING) / sum(w for _, w in pairs)
        n, F, other = len(counting), mean([own for _, _, own, _ in counting]), [other for *_, other in counting if other]
        d1, d2 = mean(other) - F if other else NOTHING, NOTHING
        z = 0.5 * sum(square(f - self.values[a]) + square(f - self.values[b]) for a, b, (f, _), _ in counting) / n + 1e-150
        if self.positions is not None:
            d2 = self.fit.at(self.places[v]) - F
            d2 = d2 if square(d2) <= 64 * z else NOTHING
        value = F + self.blends[min(n, 3)].correction(d1, d2)
        spread = sum(np.sqrt(square(f - F)) for _, _, (f, _), _ in counting[:8]) / min(n, 8)
        spread = max(spread, 0.3 * np.sqrt(square(d1)))
        return SimpleNamespace(value=value, n=n, is_linked=False, spread=spread, F=F, d1=d1, d2=d2, z=z)

    def learn(self, v, completed, prediction):
        """[ATTR-32, ATTR-34, ATTR-35] What is kept after a vertex is coded."""
        u, n = self.values[v], prediction.n
        for _, *ends in completed:
            a, b = (self.values[x] for x in ends)
            area = cross(b - a, u - a)
            self.side = 1.0 if area > 0 else -1.0 if area < 0 else self.side
        if n:
            d1, d2, e = prediction.d1, prediction.d2, u - prediction.F
            self.blends[min(n, 3)].learn(d1, d2, e, 1 / (0.02 * prediction.z + square(e) + square(d1)))
        if self.positions is not None:
            self.fit.learn(self.places[v], u, not n and not prediction.is_linked)
