"""Normals on the surface: attr_normals.md, ATTR-20 to ATTR-25."""
import math

import numpy as np

from attr import f32_rows
from coder import BitModel, Coder, bit_models, clamp, mixing_weights, symbol_models
from container import must
from graph import corners, others
from scaled import SYMBOL_WEIGHTS, ScaledCoder
from vectors import ATTR_22_corner_angles, ATTR_22_scaled, ATTR_24_point, cross, dot, sum_at_corners, to_f32, unit, vector

F = np.float32

def ATTR_20_normals(r, a, surface):
    form, radius = r.u8(), r.number("f")
    rule = form & 7
    must(rule <= 5 and form < 64, "ATTR-20", f"form {form}")
    must(rule == 0 or surface.positions is not None, "ATTR-20", "a rule without positions")
    must(float(F(1e-6)) <= radius <= 1, "ATTR-20", f"radius {radius}")
    coder = Coder(r.rest())
    normals = NormalCoder(coder, surface, rule, form, radius).decode()
    coder.end()
    return f32_rows(normals, 3)

def ATTR_22_rule(rule, surface):
    """Rule vectors, rule weights and rule noises of all vertices."""
    n, faces = surface.n, np.array(surface.faces, dtype=np.int64).reshape(-1, 3)
    if rule == 0:
        return np.zeros((n, 3), dtype=F), np.zeros(n, dtype=F), np.zeros(n, dtype=F)
    places = ATTR_22_scaled(surface.positions)[faces]
    a, b = places[:, 1] - places[:, 0], places[:, 2] - places[:, 0]
    A, B, C, normal = dot(a, a), dot(b, b), dot(b - a, b - a), cross(a, b)
    y, counted = np.sqrt(dot(normal, normal)), dot(normal, normal) > F(1e-36)
    weight = np.ones((len(faces), 3), dtype=F)  # rule 1
    if rule in (3, 4):
        weight = ATTR_22_corner_angles(a, b, y)
    if rule in (2, 4):
        weight = y[:, None] * weight
    if rule == 5:
        weight = np.stack([y / (A * B), y / (A * C), y / (B * C)], axis=1)
    turn = (A + B + C) * ((F(1) / y) * (F(1) / y))
    directions = ((F(1) / y)[:, None] * normal)[:, None, :] * weight[:, :, None]
    noises = (weight * turn[:, None]) * weight
    return tuple(sum_at_corners(faces, counted, x, n) for x in (directions, weight, noises))

def exponent(x):
    """[ATTR-25] L"""
    if not x >= 2.0**-1022:
        return -1023
    return 1024 if math.isinf(x) else math.frexp(x)[1] - 1

class NormalCoder:
    def __init__(self, coder, surface, rule, form, radius):
        self.coder, self.surface, self.radius, n = coder, surface, radius, surface.n
        self.shares, self.zeros, self.blends, self.K = form & 8, form & 16, form & 32, 0.25 / (radius * radius)
        self.vectors, self.rule_weights, self.noises = ATTR_22_rule(rule, surface)
        self.at, self.share_bits, self.zero_bit = corners(surface.faces, n), bit_models(), BitModel()
        self.models, self.weights, self.scaled = symbol_models(SYMBOL_WEIGHTS), mixing_weights(4), ScaledCoder()
        self.group_of, self.normals, self.rule_normals, self.sizes = {}, {}, {}, {}
        self.last, self.sums, self.Z, self.O = vector(0, 0, 1), vector(0, 0, 0, 0, 0), 0.0, 0.0  # sums: ff, fg, gg, ft, gt

    def decode(self):
        first = self.surface.first
        for g in range(len(first) - 1):
            for group in self.ATTR_21_groups(g, range(first[g], first[g + 1])):
                self.group_of.update((v, group) for v in group)
                self.ATTR_23_normal(g, group)
        return [self.normals[v] for v in range(self.surface.n)]

    def ATTR_21_groups(self, g, copies):
        """Lists of copies."""
        groups, few = [], sum(len(self.at[v]) for v in copies) <= 64
        for v in copies:
            group = self.ATTR_21_earlier(g, v, groups, few) if self.shares and len(copies) > 1 else None
            groups += [[]] if group is None else []
            (groups[-1] if group is None else group).append(v)
        return groups

    def ATTR_21_earlier(self, g, v, groups, few):
        """The group of earlier copies that v belongs to, or None."""
        ranked, a = [], self.vectors[v].astype(np.float64)
        for group in groups[-16:]:
            b = self.sum_of(self.vectors, group)
            divisor = np.sqrt(dot(a, a)) * np.sqrt(dot(b, b))
            cosine = dot(a, b) / divisor if divisor > 0 else 0.0
            tie = self.ATTR_21_tie(g, v, group) if few else 0
            ranked.append((cosine + (0, 0, -2, 2)[tie], cosine, tie, group))
        ranked.sort(key=lambda entry: -entry[0])
        for rank, (_, cosine, tie, group) in enumerate(ranked[:3]):
            l = sum(x < cosine for x in (0, 0.5, 0.85, 0.95, 0.99, 0.999, 0.9999))
            if self.share_bits[(rank * 4 + tie) * 8 + l].decode(self.coder):
                return group
        return None

    def ATTR_21_tie(self, g, v, group):
        """0 apart, 1 open, 2 split, 3 joined"""
        def ends(v):
            return [u for c in self.at[v] for u in others(self.surface.faces, c)]
        geometric, theirs = self.surface.geometric, [y for u in group for y in ends(u)]
        pairs = [(x, y) for x in ends(v) for y in theirs if geometric[x] == geometric[y]]
        ties = [1 if geometric[x] >= g else 3 if self.group_of[x] is self.group_of[y] else 2 for x, y in pairs]
        return max(ties, default=0)

    def sum_of(self, values, group):
        total = values[group[0]]
        for v in group[1:]:
            total = total + values[v]
        return total.astype(np.float64)

    def ATTR_23_sums(self, g, group):
        """N, R, V and c"""
        total, faces, c = np.zeros(7, dtype=F), self.surface.faces, 0
        for v in group:
            part = np.zeros(7, dtype=F)
            for u, _ in (others(faces, c) for c in self.at[v]):
                if self.surface.geometric[u] < g and any(self.normals[u]):
                    part = part + np.hstack([self.normals[u], self.rule_normals[u], self.sizes[u]]).astype(F)
                    c += 1
            total = total + part
        return total[:3].astype(np.float64), total[3:6].astype(np.float64), float(total[6]), c

    def ATTR_23_pole(self, U, M, Q):
        if U is None or M is None or not self.blends:
            P = unit(M) if U is None and M is not None else U
            return self.last if P is None else P
        ff, fg, gg, ft, gt = self.sums
        FF, GG, T = ff + 0.5, gg + 0.5, ft + 0.5
        d, x, y = FF * GG - fg * fg, 1.0, 0.0
        if d > 1e-12 * FF * GG:
            x, y = (T * GG - gt * fg) / d, (gt * FF - T * fg) / d
        P = unit(M + x * (U - M) + y * (Q - M))
        return U if P is None else P

    def ATTR_23_frame(self, P, U, M):
        v = vector(0, 0, 0) if U is None or M is None else U - M
        w = v - dot(v, P) * P
        if not dot(w, w) > 1e-20:
            v = np.eye(3)[np.argmin(abs(P))]
            w = v - dot(v, P) * P
        return P, unit(w), cross(P, unit(w))

    def ATTR_23_learn(self, n, P, U, M, Q):
        f, g, t, e = U - M, Q - M, n - M, n - P
        w = self.K / (1 + self.K * dot(e, e))
        self.sums = (1 - 1 / 256) * self.sums + w * vector(dot(f, f), dot(f, g), dot(g, g), dot(f, t), dot(g, t))

    def ATTR_23_normal(self, g, group):
        N, R, V, c = self.ATTR_23_sums(g, group)
        S, W, X = (self.sum_of(x, group) for x in (self.vectors, self.rule_weights, self.noises))
        U, i, M, Q = unit(S), 1 / c if c else 0.0, None, None
        if c:
            M, Q = i * N, i * R
        near, normal, size = i * V, vector(0, 0, 0), 0.0
        if not (self.zeros and self.zero_bit.decode(self.coder)):
            frame = self.ATTR_23_frame(self.ATTR_23_pole(U, M, Q), U, M)
            row, place, o = self.ATTR_25_numbers(S, W, X if X < 1e60 else 0.0, U, M, near, c)
            a, b = (1.5 * self.radius) * row, (1.7320508075688772 * self.radius) * (place + (0.5 if row % 2 else 0))
            normal = ATTR_24_point(a, b, *frame)
            z = np.sqrt((a / self.radius) * (a / self.radius) + (b / self.radius) * (b / self.radius))
            size = (5 * z + 3 * near) / 8 if c else z
            if o > 0 and any(normal):
                self.Z, self.O = (1 - 1 / 256) * self.Z + z, (1 - 1 / 256) * self.O + np.sqrt(o)
            if self.blends and U is not None and c:
                self.ATTR_23_learn(normal, frame[0], U, M, Q)
            if any(normal):
                self.last = normal
        for v in group:
            self.normals[v], self.sizes[v] = normal, F(size)
            self.rule_normals[v] = vector(0, 0, 0) if U is None else to_f32(U)

    def ATTR_25_numbers(self, S, W, X, U, M, near, c):
        """Row, place and o."""
        u, p = 0.0 if U is None else 1 / np.sqrt(dot(S, S)), self.Z / self.O if self.O else 0.0
        o, spread = X * (u * u), self.K * (1 - dot(M, M)) if c else 0.0
        apart = 0.0 if U is None or not c else self.K * dot(U - M, U - M)
        bend = 0.0 if U is None else self.K * (2 - 2 / (u * W))
        squares = [near * near, apart, spread, bend, o * (p * p)]
        scale = near * near if c else min(bend, 4.0)
        shift = clamp((exponent(scale) - 6) // 2, 0, 24)
        def H(x):
            return clamp(exponent(x) + 7 - 2 * shift, 0, 15)
        near, apart, spread, bend, expected = (H(x) for x in squares)
        m = 0 if c == 0 else 1 if c < 3 else 2
        row = self.number(0, (near, 16 * apart + spread, 16 * near + expected, 4 * (4 * bend + m) + near // 4), H(scale), shift)
        j = abs(row) >> shift
        g = 2 * ((0, 1, 2, 2)[j] if j < 4 else 3) + int(row % 2 == 1 and shift == 0)
        indices = (near, 8 * (apart // 2) + spread // 2, 8 * (near // 2) + expected // 2, 4 * bend + near // 4)
        place = self.number(1, tuple(8 * index + g for index in indices), H(scale), shift)
        return row, place, o

    def number(self, is_place, indices, scale, shift):
        models = [self.models[is_place, table, index] for table, index in enumerate(indices)]
        x = self.scaled.CMP_15_number(self.coder, models, self.weights[2 * scale + is_place], shift)
        must(abs(x) <= 2**24, "ATTR-25", f"number {x}")
        return x
