"""Normals on the surface: attr_normals.md, ATTR-20 to ATTR-25."""
import math

import numpy as np

from coder import BitModel, Coder, ScaledCoder, bit_models, clamp
from container import must
from vectors import (F, ATTR_22_corner_angles, ATTR_22_edges, ATTR_23_frame, ATTR_24_point, cross, dot, square,
                     sum_at_corners)

NOWHERE = F([0, 0, 0])

def ATTR_20_normals(r, a, surface):
    form, radius = r.u8(), r.number("f")
    rule = form & 7
    must(rule <= 5, "ATTR-20", f"rule {rule}")
    must(form < 64, "ATTR-20", f"form {form}")
    must(rule == 0 or surface.positions is not None, "ATTR-20", "a rule without positions")
    must(float(F(1e-6)) <= radius <= 1, "ATTR-20", f"radius {radius}")
    return NormalCoder(Coder(r), surface, rule, form, F(radius)).decode()

def ATTR_22_rule(rule, surface):
    """Rule vectors and rule weights of all vertices."""
    if rule == 0:
        return np.zeros((surface.n, 3), dtype=F), np.zeros(surface.n, dtype=F)
    a, b = ATTR_22_edges(surface.positions, surface.faces)
    A, B, C, normal = square(a), square(b), square(b - a), cross(a, b)
    y, weight = np.sqrt(square(normal)), np.ones((len(surface.faces), 3), dtype=F)  # of rule 1
    if rule in (3, 4):
        weight = ATTR_22_corner_angles(a, b, y)
    if rule in (2, 4):
        weight = y[:, None] * weight
    if rule == 5:
        weight = np.stack([y / (A * B), y / (A * C), y / (B * C)], axis=1)
    directions = ((F(1) / y)[:, None] * normal)[:, None, :] * weight[:, :, None]
    return tuple(sum_at_corners(surface, square(normal) > F(1e-36), x) for x in (directions, weight))

def exponent(x):
    """[ATTR-25] L"""
    if not x >= F(2.0**-126):
        return -127
    return 128 if np.isinf(x) else math.frexp(x)[1] - 1

class NormalCoder:  # ATTR-20 to ATTR-25
    def __init__(self, coder, surface, rule, form, radius):
        self.coder, self.surface, self.radius = coder, surface, radius
        self.shares, self.zeros, self.blends, self.K = form & 8, form & 16, form & 32, F(0.25) / (radius * radius)
        self.vectors, self.rule_weights = ATTR_22_rule(rule, surface)
        self.share_bits, self.zero_bit, self.numbers = bit_models(), BitModel(), ScaledCoder()
        self.group_of, self.kept = {}, {}  # of a vertex its normal, its rule normal and its size, in one vector
        self.last, self.X, self.Y, self.y = F([0, 0, 1]), F(0), F(0), F(0)

    def decode(self):  # ATTR-20, ATTR-21
        first = self.surface.first
        for g in range(len(first) - 1):
            for group in self.ATTR_21_groups(g, range(first[g], first[g + 1])):
                self.group_of.update((v, group) for v in group)
                self.ATTR_23_normal(g, group)
        return [self.kept[v][:3] for v in range(self.surface.n)]

    def ATTR_21_groups(self, g, copies):
        """Lists of copies."""
        groups, few = [], sum(len(self.surface.corners[v]) for v in copies) <= 64
        for v in copies:
            group = self.ATTR_21_earlier(g, v, groups, few) if self.shares else None
            if group is None:
                groups.append([v])
            else:
                group.append(v)
        return groups

    def ATTR_21_earlier(self, g, v, groups, few):
        """The group of earlier copies that v belongs to, or None."""
        ranked, a = [], self.vectors[v]
        for group in groups[-16:]:
            b = self.sum_of(self.vectors, group)
            divisor = np.sqrt(square(a)) * np.sqrt(square(b))
            cosine = dot(a, b) / divisor if divisor > 0 else F(0)
            tie = self.ATTR_21_tie(g, v, group) if few else 0
            ranked.append((cosine + F((0, 0, -2, 2)[tie]), cosine, tie, group))
        ranked.sort(key=lambda entry: -entry[0])
        for rank, (_, cosine, tie, group) in enumerate(ranked[:3]):
            l = sum(F(x) < cosine for x in (0, 0.5, 0.85, 0.95, 0.99, 0.999, 0.9999))
            if self.share_bits[(rank * 4 + tie) * 8 + l].decode(self.coder):
                return group
        return None

    def ATTR_21_tie(self, g, v, group):
        """0 apart, 1 open, 2 split, 3 joined"""
        def ends(v):
            return [u for _, *both in self.surface.corners[v] for u in both]
        geometric, theirs = self.surface.geometric, [y for u in group for y in ends(u)]
        pairs = [(x, y) for x in ends(v) for y in theirs if geometric[x] == geometric[y]]
        ties = [1 if geometric[x] >= g else 3 if self.group_of[x] is self.group_of[y] else 2 for x, y in pairs]
        return max(ties, default=0)

    def sum_of(self, values, group):  # ATTR-21, ATTR-23
        return sum((values[v] for v in group[1:]), values[group[0]])

    def ATTR_23_sums(self, g, group):
        """N, R, V and c"""
        total, c, geometric = np.zeros(7, dtype=F), 0, self.surface.geometric
        for v in group:
            around = [self.kept[u] for _, u, _ in self.surface.corners[v] if geometric[u] < g and any(self.kept[u][:3])]
            total, c = total + sum(around, np.zeros(7, dtype=F)), c + len(around)
        return total[:3], total[3:6], total[6], c

    def ATTR_23_pole(self, U, M, Q):
        """P"""
        if U is None:
            return M if M is not None and square(M) > F(1e-12) else self.last
        P = U + self.y * (M - Q) if M is not None and self.blends else U
        return P if square(P) > F(1e-12) else U

    def ATTR_23_learn(self, n, U, M, Q, z):
        G, k, keep = M - Q, self.K / (F(1) + z), F(1 - 1 / 256)
        self.X, self.Y = keep * self.X + k * square(G), keep * self.Y + k * dot(G, n - U)
        self.y = self.Y / (self.X + F(0.5))

    def ATTR_23_normal(self, g, group):
        N, R, V, c = self.ATTR_23_sums(g, group)
        S, W = (self.sum_of(x, group) for x in (self.vectors, self.rule_weights))
        u = F(1) / np.sqrt(square(S))
        U = u * S if F(1e-36) < square(S) < F(1e36) else None
        M, Q, near = (F(1) / F(c) * x for x in (N, R, V)) if c else (None, None, F(0))
        normal, size = NOWHERE, F(0)
        if not (self.zeros and self.zero_bit.decode(self.coder)):
            frame = ATTR_23_frame(self.ATTR_23_pole(U, M, Q), NOWHERE if U is None or M is None else U - M)
            row, place = self.ATTR_25_numbers(u * W, U, M, near, c)
            a, b = F(1.5) * F(row), F(1.7320508) * (F(place) + F(0.5 if row % 2 else 0))
            self.last = normal = ATTR_24_point(self.radius * a, self.radius * b, *frame)
            z = a * a + b * b
            size = (F(5) * np.sqrt(z) + F(3) * near) * F(0.125) if c else np.sqrt(z)
            if self.blends and U is not None and c:
                self.ATTR_23_learn(normal, U, M, Q, z)
        for v in group:
            self.kept[v] = np.hstack([normal, NOWHERE if U is None else U, size])

    def ATTR_25_numbers(self, uW, U, M, near, c):
        """Row and place."""
        spread = self.K * (F(1) - square(M)) if c else F(0)
        apart = F(0) if U is None or not c else self.K * square(U - M)
        bend = F(0) if U is None else (F(2) * self.K) * (uW - F(1))
        scale = near * near if c else min(bend, F(4))
        shift = clamp((exponent(scale) - 6) // 2, 0, 24)
        scale, apart, spread, bend = (clamp(exponent(x) + 7 - 2 * shift, 0, 15) for x in (scale, apart, spread, bend))
        row = self.number(0, (16 * scale + bend, 16 * apart + spread), scale, shift)
        j = abs(row) >> shift
        g = 2 * ((0, 1, 2, 2)[j] if j < 4 else 3) + int(row % 2 == 1 and shift == 0)
        indices = (8 * (scale // 2) + bend // 2, 8 * (apart // 2) + spread // 2)
        return row, self.number(1, tuple(8 * index + g for index in indices), scale, shift)

    def number(self, is_place, indices, scale, shift):  # ATTR-25
        first, second = ((is_place, index) for index in indices)
        return self.numbers.CMP_15_number(self.coder, first, second, 2 * scale + is_place, shift)
