"""Texture coordinates off the surface: attr_uvs.md, ATTR-31 to ATTR-37."""
import math

import numpy as np

from attr import f32_rows
from coder import Coder, clamp
from container import must
from graph import corners, others
from vectors import dot, sub, times
from walk import ATTR_30_walk, BitOfFaces, Blend, PairCoder, at_most, cross2, dot2, sub2

def ATTR_31_uvs(r, a, surface):
    step = r.number("f")
    must(2.0**-100 <= step <= 2.0**64, "ATTR-31", f"step {step}")
    coder = Coder(r.rest())
    values = UvCoder(coder, surface, step).decode()
    coder.end()
    return f32_rows([values[v] for v in range(surface.n)], 2)

def solve_symmetric(a, b, c, e, f, i, right):
    """[ATTR-33]"""
    aa, ab, ac, bb, bc, cc = e * i - f * f, c * f - b * i, b * f - c * e, a * i - c * c, b * c - a * f, a * e - b * b
    determinant = a * aa + b * ab + c * ac
    if not determinant > 0:
        return 0.0, 0.0, 0.0
    return tuple(dot(row, right) * (1 / determinant) for row in ((aa, ab, ac), (ab, bb, bc), (ac, bc, cc)))

class Fit:
    """[ATTR-34] A linear function of a place; U and Q have a part for u and one for v."""
    def __init__(self):
        self.N, self.U, self.P, self.Q, self.S = 0.0, [0.0] * 2, [0.0] * 3, [[0.0] * 3, [0.0] * 3], [0.0] * 6
        self.number, self.function = 0, None

    def learn(self, p, u, is_first):
        self.number = 0 if is_first else self.number + 1
        if is_first:
            self.decay(1 / 1024)
        if self.number < 8 or self.number % 4 == 0:
            self.decay(0.98)
            self.N = self.N + 1
            self.U = [x + y for x, y in zip(self.U, u)]
            self.P = [x + y for x, y in zip(self.P, p)]
            self.Q = [[x + y * z for x, y in zip(row, p)] for row, z in zip(self.Q, u)]
            self.S = [x + p[i] * p[j] for x, (i, j) in zip(self.S, ((0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)))]
            self.make()

    def decay(self, k):
        self.N, self.U, self.P, self.S = self.N * k, [x * k for x in self.U], [x * k for x in self.P], [x * k for x in self.S]
        self.Q = [[x * k for x in row] for row in self.Q]

    def make(self):
        h = 1 / self.N
        M, V = times(h, self.P), times(h, self.U)
        C = [h * s - M[i] * M[j] for s, (i, j) in zip(self.S, ((0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)))]
        ridge = 1e-6 * (C[0] + C[3] + C[5]) + 1e-12
        C = [C[0] + ridge, C[1], C[2], C[3] + ridge, C[4], C[5] + ridge]
        slopes = [solve_symmetric(*C, [h * q - m * value for q, m in zip(self.Q[k], M)]) for k, value in enumerate(V)]
        self.function = M, V, slopes

    def at(self, p):
        if not self.function:
            return 0.0, 0.0
        M, V, slopes = self.function
        return tuple(V[k] + (p[0] - M[0]) * G[0] + (p[1] - M[1]) * G[1] + (p[2] - M[2]) * G[2] for k, G in enumerate(slopes))

class Forecast:
    """[ATTR-33] What is known of a vertex' value before it is coded."""
    def __init__(self, value, n=0, kind=0):
        self.value, self.n, self.kind, self.spread = value, n, kind, 0.0

class UvCoder:
    def __init__(self, coder, surface, step):
        self.coder, self.surface, self.step = coder, surface, step
        self.positions = surface.positions if surface.positions is None else surface.positions.astype(np.float64).tolist()
        self.faces, self.at, self.values = surface.faces, corners(surface.faces, surface.n), {}
        self.kept, self.side, self.blends, self.fit = {}, 1.0, [Blend() for _ in range(4)], Fit()
        self.same, self.pairs, self.copy_of = BitOfFaces(coder), PairCoder(coder), {}
        if self.positions:
            low, high = ([float(f(c)) for c in zip(*self.positions)] for f in (min, max))
            longest = max(sub(high, low)) or 1.0
            self.places = [times(1 / longest, sub(p, [0.5 * (a + b) for a, b in zip(low, high)])) for p in self.positions]

    def decode(self):
        last = (0.0, 0.0)
        for v, completed in ATTR_30_walk(self.faces, self.surface.n):
            around = [u for c in completed for u in others(self.faces, c)]
            forecast = self.ATTR_33_forecast(v, completed, last)
            last = self.values[v] = self.value(v, around, forecast)
            self.learn(v, completed, forecast)
        return self.values

    def value(self, v, around, forecast):
        """[ATTR-36, ATTR-37]"""
        g, self.kept[v] = self.surface.geometric[v], 0
        copy, self.copy_of[g] = self.copy_of.get(g), v
        if copy is not None and self.same.decode(v, around):
            return self.values[copy]
        near, spread, kind = 4096, 4096, forecast.kind
        if forecast.n:
            near = sum(self.kept[u] for u in around) // len(around)
            spread, kind = at_most(forecast.spread * (16 / self.step), 2**17), 1 + min(forecast.n, 3)
        p, q = self.pairs.decode((near, near), (spread, spread), kind)
        if forecast.n:
            self.kept[v] = (5 * min(8 * (abs(p) + abs(q)), 2**17) + 3 * near) >> 3
        limit = 2.0**22 * self.step
        centre = [0.0 if math.isnan(x) else clamp(x, -limit, limit) for x in forecast.value]
        return tuple(f32_rows([[x + self.step * y for x, y in zip(centre, (p, q))]], 2)[0].tolist())

    def across(self, own, a, b):
        """[ATTR-32] The coded vertex across the edge from b to a, or None."""
        for corner in self.at[a]:
            third, before = others(self.faces, corner)
            if corner // 3 != own and before == b and third in self.values:
                return third
        return None

    def over_edge(self, a, b, c):
        """[ATTR-32] x and y of c over the edge from a to b, or None where the face does not count."""
        A, B, C = self.positions[a], self.positions[b], self.positions[c]
        e, w = sub(B, A), sub(C, A)
        q, ww = dot(e, e), dot(w, w)
        if q == 0 or not ww * (1 / q) <= 1e6:
            return None
        x = dot(e, w) * (1 / q)
        return x, math.sqrt(max(ww * (1 / q) - x * x, 0.0))

    def ATTR_32_face(self, v, corner):
        """Forecast, its weight, the other forecast, its weight (None where there is none); None if the face does not count."""
        ia, ib = others(self.faces, corner)
        a, b = self.values[ia], self.values[ib]
        across = self.across(corner // 3, ia, ib)
        o, middle = self.values.get(across), (0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1]))
        if self.positions is None:
            if across is None:
                return middle, 0.25, middle, 1.0
            return (a[0] + b[0] - o[0], a[1] + b[1] - o[1]), 1.0, middle, 1.0
        own = self.over_edge(ia, ib, v)
        if own is None:
            return None
        beyond = across is not None and self.over_edge(ia, ib, across)
        (x, y), E, side = own, sub2(b, a), self.side
        foot = a[0] + x * E[0], a[1] + x * E[1]
        m, other, other_weight = 1 / (y + 0.01), None, None
        if beyond:
            d = cross2(E, sub2(o, a))
            side = 1.0 if d < 0 else -1.0 if d > 0 else side
            if beyond[1] > 0.05:
                t = y / beyond[1]
                r = min(t, 4.0)
                other = tuple(foot[k] + t * ((a[k] + beyond[0] * E[k]) - o[k]) for k in (0, 1))
                other_weight = m / (1 + r * r)
        return (foot[0] + (side * y) * -E[1], foot[1] + (side * y) * E[0]), m, other, other_weight

    def ATTR_33_forecast(self, v, completed, last):
        counting = [(c, found) for c in completed if (found := self.ATTR_32_face(v, c))]
        if not counting:
            for u in (u for c in self.at[v] for u in others(self.faces, c)):
                if u in self.values:
                    return Forecast(self.values[u], kind=1)
            return Forecast(last)
        n = len(counting)
        def mean(pairs):
            total = [0.0, 0.0, 0.0]
            for f, w in pairs:
                total = [total[0] + w * f[0], total[1] + w * f[1], total[2] + w]
            return total[0] / total[2], total[1] / total[2]
        forecasts = [found[0] for _, found in counting]
        F = mean([found[:2] for _, found in counting])
        other = [found[2:] for _, found in counting if found[2]]
        s, d1, d2 = 0.0, sub2(mean(other), F) if other else (0.0, 0.0), (0.0, 0.0)
        for (c, _), f in zip(counting, forecasts):
            a, b = (sub2(f, self.values[u]) for u in others(self.faces, c))
            s = s + (dot2(a, a) + dot2(b, b))
        z = 0.5 * s / n + 1e-150
        if self.positions:
            d2 = sub2(self.fit.at(self.places[v]), F)
            d2 = d2 if dot2(d2, d2) <= 64 * z else (0.0, 0.0)
        correction = self.blends[min(n, 3)].correction(d1, d2)
        forecast = Forecast((F[0] + correction[0], F[1] + correction[1]), n)
        off = 0.0
        for f in forecasts[:8]:
            off = off + math.sqrt(dot2(sub2(f, F), sub2(f, F)))
        forecast.spread = max(off / min(n, 8), 0.3 * math.sqrt(dot2(d1, d1)))
        forecast.F, forecast.d1, forecast.d2, forecast.z = F, d1, d2, z
        return forecast

    def learn(self, v, completed, forecast):
        """[ATTR-32, ATTR-34, ATTR-35] What is kept after a vertex is coded."""
        u = self.values[v]
        for c in completed:
            a, b = (self.values[x] for x in others(self.faces, c))
            area = cross2(sub2(b, a), sub2(u, a))
            self.side = 1.0 if area > 0 else -1.0 if area < 0 else self.side
        if forecast.n:
            d1, d2, e = forecast.d1, forecast.d2, sub2(u, forecast.F)
            g = 1 / (0.02 * forecast.z + dot2(e, e) + dot2(d1, d1))
            self.blends[min(forecast.n, 3)].learn(d1, d2, e, g)
        if self.positions:
            self.fit.learn(self.places[v], u, forecast.n == 0 and forecast.kind == 0)
