"""Tangents off the surface: attr_tangents.md, ATTR-38 to ATTR-44."""
import math

import numpy as np

from attr import NORMAL, UV, f32_rows
from coder import Coder
from container import must
from graph import corners, others
from vectors import (ATTR_22_corner_angles, ATTR_22_scaled, ATTR_24_point, add, cross, dot, f32_cross, f32_dot, sub, sum_at_corners,
                     times, to_f32, unit)
from walk import ATTR_30_walk, BitOfFaces, Blend, PairCoder, at_most, dot2

NOTHING = (0.0, 0.0)

def ATTR_38_tangents(r, a, surface):
    step = r.number("f")
    must(2.0**-20 <= step <= 1, "ATTR-38", f"step {step}")
    coder = Coder(r.rest())
    tangents = TangentCoder(coder, surface, step).decode()
    coder.end()
    return f32_rows([tangents[v] for v in range(surface.n)], 4)

def first_of(surface, kind, k):
    return next((a.values for a in surface.attributes if a.is_shape(kind, ["f4"], [k])), None)

def ATTR_39_normals(surface):
    """Unit normals of the vertices, (0, 0, 0) where there are none."""
    normals, n = first_of(surface, NORMAL, 3), surface.n
    if normals is not None:
        rows = [tuple(row) for row in normals.astype(np.float64).tolist()]
    elif surface.positions is None:
        return [(0.0, 0.0, 0.0)] * n
    else:
        places, rows = surface.positions.astype(np.float64).tolist(), []
        of_face = [cross(sub(places[y], places[x]), sub(places[z], places[x])) for x, y, z in surface.faces]
        for at in corners(surface.faces, n):
            total = (0.0, 0.0, 0.0)
            for corner in at:
                total = add(total, of_face[corner // 3])
            rows.append(to_f32(unit(total) or (0.0, 0.0, 0.0)))
    return [unit(row) or (0.0, 0.0, 0.0) for row in rows]

class Rule:
    """[ATTR-40] R and Q (or None), the dispersion, and whether the vertex is mirrored."""
    def __init__(self, S=(0.0,) * 3, W=0.0, T=(0.0,) * 3, A=0.0, normal=(0.0,) * 3):
        def across(x):
            return sub(x, times(dot(normal, x), normal))
        self.R = unit(across(S))
        self.Q = unit(across(T)) or self.R
        self.dispersion = math.sqrt(2 * max(0.0, 1 - math.sqrt(dot(S, S)) / W)) if W > 0 else 0.0
        self.mirrored = A < 0

def ATTR_40_rules(surface, normals):
    uvs, n = first_of(surface, UV, 2), surface.n
    if uvs is None or surface.positions is None:
        return [Rule()] * n
    F, faces = np.float32, np.array(surface.faces, dtype=np.int64).reshape(-1, 3)
    with np.errstate(all="ignore"):
        places, uv = ATTR_22_scaled(surface.positions)[faces], ATTR_22_scaled(uvs)[faces]
        a, b, d1, d2 = places[:, 1] - places[:, 0], places[:, 2] - places[:, 0], uv[:, 1] - uv[:, 0], uv[:, 2] - uv[:, 0]
        normal, area = f32_cross(a, b), d1[:, 0] * d2[:, 1] - d2[:, 0] * d1[:, 1]
        G = d2[:, 1:] * a - d1[:, 1:] * b
        G = np.where((area < 0)[:, None], -G, G)
        GG, nn = f32_dot(G, G), f32_dot(normal, normal)
        counted = (area != 0) & (GG > F(1e-36)) & (nn > F(1e-36))
        w = ATTR_22_corner_angles(a, b, np.sqrt(nn))
        terms = [(w * (F(1) / np.sqrt(GG))[:, None])[:, :, None] * G[:, None, :], w, np.stack([G] * 3, axis=1), np.stack([area] * 3, axis=1)]
        sums = [sum_at_corners(faces, counted, x, n).astype(np.float64).tolist() for x in terms]
    return [Rule(*rows) for rows in zip(*sums, normals)]

class TangentCoder:
    def __init__(self, coder, surface, step):
        self.coder, self.surface, self.step = coder, surface, step
        self.normals = ATTR_39_normals(surface)
        self.rules = ATTR_40_rules(surface, self.normals)
        self.blends, self.pairs = [Blend() for _ in range(5)], PairCoder(coder)
        self.same, self.sign, self.copy_of = BitOfFaces(coder), BitOfFaces(coder), {}
        self.tangents, self.off, self.kept = {}, {}, {}

    def decode(self):
        last = (0.0, 0.0, 0.0)
        for v, completed in ATTR_30_walk(self.surface.faces, self.surface.n):
            self.ATTR_41_vertex(v, len(completed), [u for c in completed for u in others(self.surface.faces, c)], last)
            last = self.tangents[v][:3]
        return self.tangents

    def ATTR_41_frame(self, P, normal):
        """The first and the second axis."""
        for x in (normal, (1.0, 0.0, 0.0) if abs(P[0]) < 0.6 else (0.0, 1.0, 0.0)):
            second = sub(x, times(dot(P, x), P))
            if dot(second, second) > 1e-6:
                break
        second = unit(second)
        return cross(second, P), second

    def ATTR_41_place(self, V, P, first, second):
        p, a, b = dot(V, P), dot(V, first), dot(V, second)
        if p >= 0:
            return a / (1 + p), b / (1 + p)
        a, b = a / (1 - p), b / (1 - p)
        d = math.sqrt(a * a + b * b)
        return (a * ((2 - d) / d), b * ((2 - d) / d)) if d else (2.0, 0.0)

    def ATTR_41_vertex(self, v, faces, around, last):
        rule, M, O = self.rules[v], (0.0, 0.0, 0.0), NOTHING
        for u in around:
            M = add(M, self.tangents[u][:3])
        offs = [self.off[u] for u in around if u in self.off]
        for off in offs:
            O = O[0] + off[0], O[1] + off[1]
        mean = unit(M if faces else last)
        P = rule.R or mean or (1.0, 0.0, 0.0)
        source = 2 + min(faces, 2) if rule.R else 1 if mean else 0
        first, second = self.ATTR_41_frame(P, self.normals[v])
        d1 = d2 = NOTHING
        if rule.R:
            d1 = (O[0] / len(offs), O[1] / len(offs)) if offs else NOTHING
            d2 = self.ATTR_41_place(rule.Q, P, first, second)
            d1, d2 = (d if dot2(d, d) <= 2.25 else NOTHING for d in (d1, d2))
        centre = self.blends[source].correction(d1, d2)
        centre = centre if dot2(centre, centre) <= 1 else NOTHING
        spread = NOTHING
        if rule.R:
            spread = 0.5 * abs(d1[0] - centre[0]) + 0.25 * rule.dispersion, 0.5 * abs(d1[1] - centre[1])
        self.tangents[v] = self.value(v, around, rule, source, centre, spread, (P, first, second))
        direction = unit(self.tangents[v][:3])
        if rule.R and direction:
            off = self.ATTR_41_place(direction, P, first, second)
            if dot2(off, off) <= 2.25:
                self.off[v] = off
                g = 1 / (1e-12 + dot2(off, off) + dot2(d1, d1) + dot2(d2, d2))
                self.blends[source].learn(d1, d2, off, g)

    def value(self, v, around, rule, source, centre, spread, frame):
        """[ATTR-42 to ATTR-44]"""
        g, self.kept[v] = self.surface.geometric[v], (0, 0)
        copy, self.copy_of[g] = self.copy_of.get(g), v
        if copy is not None and self.same.decode(v, around):
            return self.tangents[copy]
        sign = -1.0 if rule.mirrored else 1.0
        sign = sign if self.sign.decode(v, around) else -sign
        near = tuple(sum(self.kept[u][i] for u in around) // len(around) if around else 4096 for i in (0, 1))
        spread = tuple(at_most(x * (16 / self.step), 2**17) for x in spread)
        numbers = self.pairs.decode(near, spread, source)
        self.kept[v] = tuple((5 * min(16 * abs(p), 2**17) + 3 * x) >> 3 for p, x in zip(numbers, near))
        a, b = (c + self.step * p for c, p in zip(centre, numbers))
        return ATTR_24_point(a, b, *frame) + (sign,)
