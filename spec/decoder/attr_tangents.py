"""Tangents off the surface: attr_tangents.md, ATTR-38 to ATTR-44."""
from types import SimpleNamespace

import numpy as np

from attr import NORMAL, UV
from coder import Coder
from container import must
from attr_normals import ATTR_22_rule, NOWHERE
from surface_order import ATTR_30_order, BitOfFaces, PairCoder, whole_part
from vectors import (F, ATTR_22_corner_angles, ATTR_22_edges, ATTR_23_frame, ATTR_24_point, cross, dot, square,
                     sum_at_corners)

NOTHING = F([0, 0])

def ATTR_38_tangents(r, a, surface):
    step = r.number("f")
    must(2.0**-20 <= step <= 1, "ATTR-38", f"step {step}")
    return TangentCoder(Coder(r), surface, F(step)).decode()

def ATTR_39_first(surface, kind, k):
    return next((a.values for a in surface.attributes if a.is_shape(kind, ["f4"], [k])), None)

def ATTR_39_normals(surface):
    normals = ATTR_39_first(surface, NORMAL, 3)
    if normals is not None:
        return list(normals)
    if surface.positions is None:
        return [NOWHERE] * surface.n
    return [(F(1) / np.sqrt(square(x))) * x if square(x) > F(1e-36) else NOWHERE for x in ATTR_22_rule(2, surface)[0]]

def ATTR_40_rule(S=NOWHERE, W=F(0), A=F(0), N=NOWHERE):
    """R (or None), the dispersion, and whether the vertex is mirrored."""
    R = S - dot(N, S) * N
    spread = F(1) - square(S) / (W * W) if W > 0 else F(0)
    dispersion = np.sqrt(spread) if spread > 0 else F(0)
    return SimpleNamespace(R=R if F(1e-12) < square(R) < F(1) / F(1e-12) else None, dispersion=dispersion, mirrored=A < 0)

def ATTR_40_rules(surface, normals):
    uvs = ATTR_39_first(surface, UV, 2)
    if uvs is None or surface.positions is None:
        return [ATTR_40_rule()] * surface.n
    (a, b), (d1, d2) = ATTR_22_edges(surface.positions, surface.faces), ATTR_22_edges(uvs, surface.faces)
    nn, area = square(cross(a, b)), cross(d1, d2)
    G = d2[:, 1:] * a - d1[:, 1:] * b
    G = np.where((area < 0)[:, None], -G, G)
    GG = square(G)
    counted, w = (area != 0) & (GG > F(1e-36)) & (nn > F(1e-36)), ATTR_22_corner_angles(a, b, np.sqrt(nn))
    terms = [(w * (F(1) / np.sqrt(GG))[:, None])[:, :, None] * G[:, None, :], w, np.stack([area] * 3, axis=1)]
    sums = [sum_at_corners(surface, counted, x) for x in terms]
    return [ATTR_40_rule(*rows) for rows in zip(*sums, normals)]

class TangentCoder:  # ATTR-38 to ATTR-44
    def __init__(self, coder, surface, step):
        self.surface, self.step, self.normals = surface, step, ATTR_39_normals(surface)
        self.rules = ATTR_40_rules(surface, self.normals)
        self.X, self.Y, self.pairs = np.zeros(5, dtype=F), np.zeros(5, dtype=F), PairCoder(coder)
        self.same, self.sign, self.tangents, self.off, self.kept = BitOfFaces(coder), BitOfFaces(coder), {}, {}, {}

    def decode(self):  # ATTR-38
        last = NOWHERE
        for v, completed, around, copy in ATTR_30_order(self.surface):
            self.ATTR_41_vertex(v, len(completed), around, copy, last)
            last = self.tangents[v][:3]
        return [self.tangents[v] for v in range(self.surface.n)]

    def ATTR_41_vertex(self, v, faces, around, copy, last):
        rule, offs = self.rules[v], [self.off[u] for u in around if u in self.off]
        M = sum((self.tangents[u][:3] for u in around), NOWHERE) if faces else last
        has_rule, has_mean, d, centre, spread = rule.R is not None, square(M) > F(1e-12), NOTHING, NOTHING, NOTHING
        source = 2 + min(faces, 2) if has_rule else int(has_mean)
        pole, second, first = ATTR_23_frame(rule.R if has_rule else M if has_mean else F([1, 0, 0]), self.normals[v])
        if has_rule:
            d = sum(offs, NOTHING) / F(len(offs)) if offs else NOTHING
            centre = (self.Y[source] / (self.X[source] + F(0.02))) * d
            centre = centre if square(centre) <= 1 else NOTHING
            spread = F(0.5) * abs(d - centre) + F([F(0.25) * rule.dispersion, 0])
        self.tangents[v] = self.ATTR_44_value(v, around, copy, rule, source, centre, spread, (pole, first, second))
        if has_rule:
            T = self.tangents[v][:3]
            off = (F(1) / (F(1) + max(dot(pole, T), F(-0.5)))) * F([dot(first, T), dot(second, T)])
            if square(off) <= 2.25:
                self.off[v], g = off, F(1) / (F(1e-12) + square(off) + square(d))
                self.X[source] = F(0.99) * self.X[source] + g * square(d)
                self.Y[source] = F(0.99) * self.Y[source] + g * dot(d, off)

    def ATTR_44_value(self, v, around, copy, rule, source, centre, spread, frame):
        """[ATTR-42 to ATTR-44]"""
        self.kept[v] = (0, 0)
        if copy is not None and self.same.decode(v, around):
            return self.tangents[copy]
        expected = -1.0 if rule.mirrored else 1.0
        sign = expected if self.sign.decode(v, around) else -expected
        near = tuple(sum(self.kept[u][i] for u in around) // len(around) if around else 4096 for i in (0, 1))
        numbers = self.pairs.decode(near, tuple(whole_part(x * (F(16) / self.step)) for x in spread), source)
        self.kept[v] = tuple((5 * min(16 * abs(p), 2**17) + 3 * x) >> 3 for p, x in zip(numbers, near))
        return np.append(ATTR_24_point(*(centre + self.step * F(numbers)), *frame), F(sign))
