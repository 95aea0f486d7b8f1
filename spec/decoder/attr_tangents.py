"""Tangents off the surface: attr_tangents.md, ATTR-38 to ATTR-44."""
from types import SimpleNamespace

import numpy as np

from attr import NORMAL, UV, f32_rows
from coder import Coder
from container import must
from graph import corners, others
from vectors import ATTR_22_corner_angles, ATTR_22_scaled, ATTR_24_point, cross, dot, sum_at_corners, to_f32, unit, vector
from walk import ATTR_30_walk, BitOfFaces, Blend, PairCoder, whole_part

NOTHING, NOWHERE = vector(0, 0), vector(0, 0, 0)

def ATTR_38_tangents(r, a, surface):
    step = r.number("f")
    must(2.0**-20 <= step <= 1, "ATTR-38", f"step {step}")
    coder = Coder(r.rest())
    tangents = TangentCoder(coder, surface, step).decode()
    coder.end()
    return f32_rows([tangents[v] for v in range(surface.n)], 4)

def ATTR_39_first(surface, kind, k):
    return next((a.values for a in surface.attributes if a.is_shape(kind, ["f4"], [k])), None)

def ATTR_39_normals(surface):
    """Unit normals of the vertices, 0 where there are none."""
    normals, rows = ATTR_39_first(surface, NORMAL, 3), []
    if normals is not None:
        rows = normals.astype(np.float64)
    elif surface.positions is None:
        rows = [NOWHERE] * surface.n
    else:
        places = surface.positions.astype(np.float64)
        of_face = [cross(places[y] - places[x], places[z] - places[x]) for x, y, z in surface.faces]
        for at in corners(surface.faces, surface.n):
            total = unit(sum((of_face[c // 3] for c in at), NOWHERE))
            rows.append(NOWHERE if total is None else to_f32(total))
    units = [unit(row) for row in rows]
    return [NOWHERE if x is None else x for x in units]

def ATTR_40_rule(S=NOWHERE, W=0.0, T=NOWHERE, A=0.0, N=NOWHERE):
    """R and Q (or None), the dispersion, and whether the vertex is mirrored."""
    R, Q = (unit(x - dot(N, x) * N) for x in (S, T))
    dispersion = np.sqrt(2 * max(0.0, 1 - np.sqrt(dot(S, S)) / W)) if W > 0 else 0.0
    return SimpleNamespace(R=R, Q=R if Q is None else Q, dispersion=dispersion, mirrored=A < 0)

def ATTR_40_rules(surface, normals):
    uvs, F, faces = ATTR_39_first(surface, UV, 2), np.float32, np.array(surface.faces, dtype=np.int64).reshape(-1, 3)
    if uvs is None or surface.positions is None:
        return [ATTR_40_rule()] * surface.n
    places, uv = ATTR_22_scaled(surface.positions)[faces], ATTR_22_scaled(uvs)[faces]
    a, b, d1, d2 = places[:, 1] - places[:, 0], places[:, 2] - places[:, 0], uv[:, 1] - uv[:, 0], uv[:, 2] - uv[:, 0]
    normal, area = cross(a, b), d1[:, 0] * d2[:, 1] - d2[:, 0] * d1[:, 1]
    G = d2[:, 1:] * a - d1[:, 1:] * b
    G = np.where((area < 0)[:, None], -G, G)
    GG, nn = dot(G, G), dot(normal, normal)
    counted, w = (area != 0) & (GG > F(1e-36)) & (nn > F(1e-36)), ATTR_22_corner_angles(a, b, np.sqrt(nn))
    terms = [(w * (F(1) / np.sqrt(GG))[:, None])[:, :, None] * G[:, None, :], w, np.stack([G] * 3, axis=1), np.stack([area] * 3, axis=1)]
    sums = [sum_at_corners(faces, counted, x, surface.n).astype(np.float64) for x in terms]
    return [ATTR_40_rule(*rows) for rows in zip(*sums, normals)]

class TangentCoder:
    def __init__(self, coder, surface, step):
        self.coder, self.surface, self.step, self.normals = coder, surface, step, ATTR_39_normals(surface)
        self.rules = ATTR_40_rules(surface, self.normals)
        self.blends, self.pairs = [Blend() for _ in range(5)], PairCoder(coder)
        self.same, self.sign, self.copy_of = BitOfFaces(coder), BitOfFaces(coder), {}
        self.tangents, self.off, self.kept = {}, {}, {}

    def decode(self):
        last = NOWHERE
        for v, completed in ATTR_30_walk(self.surface.faces, self.surface.n):
            self.ATTR_41_vertex(v, len(completed), [u for c in completed for u in others(self.surface.faces, c)], last)
            last = self.tangents[v][:3]
        return self.tangents

    def ATTR_41_frame(self, P, normal):
        """The pole and both axes."""
        for x in (normal, vector(1, 0, 0) if abs(P[0]) < 0.6 else vector(0, 1, 0)):
            second = x - dot(P, x) * P
            if dot(second, second) > 1e-6:
                break
        second = unit(second)
        return P, cross(second, P), second

    def ATTR_41_place(self, V, frame):
        p, a, b = (dot(V, x) for x in frame)
        if p >= 0:
            return vector(a, b) / (1 + p)
        place = vector(a, b) / (1 - p)
        d = np.sqrt(dot(place, place))
        return place * ((2 - d) / d) if d else vector(2, 0)

    def ATTR_41_vertex(self, v, faces, around, last):
        rule, offs = self.rules[v], [self.off[u] for u in around if u in self.off]
        mean = unit(sum((self.tangents[u][:3] for u in around), NOWHERE) if faces else last)
        has_rule, has_mean, d1, d2, spread = rule.R is not None, mean is not None, NOTHING, NOTHING, NOTHING
        source = 2 + min(faces, 2) if has_rule else int(has_mean)
        frame = self.ATTR_41_frame(rule.R if has_rule else mean if has_mean else vector(1, 0, 0), self.normals[v])
        if has_rule:
            d1, d2 = sum(offs, NOTHING) / len(offs) if offs else NOTHING, self.ATTR_41_place(rule.Q, frame)
            d1, d2 = (d if dot(d, d) <= 2.25 else NOTHING for d in (d1, d2))
        centre = self.blends[source].correction(d1, d2)
        centre = centre if dot(centre, centre) <= 1 else NOTHING
        if has_rule:
            spread = 0.5 * abs(d1 - centre) + vector(0.25 * rule.dispersion, 0)
        self.tangents[v] = self.ATTR_44_value(v, around, rule, source, centre, spread, frame)
        direction = unit(self.tangents[v][:3])
        if has_rule and direction is not None:
            off = self.ATTR_41_place(direction, frame)
            if dot(off, off) <= 2.25:
                self.off[v] = off
                self.blends[source].learn(d1, d2, off, 1 / (1e-12 + dot(off, off) + dot(d1, d1) + dot(d2, d2)))

    def ATTR_44_value(self, v, around, rule, source, centre, spread, frame):
        """[ATTR-42 to ATTR-44]"""
        g, self.kept[v] = self.surface.geometric[v], (0, 0)
        copy, self.copy_of[g] = self.copy_of.get(g), v
        if copy is not None and self.same.decode(v, around):
            return self.tangents[copy]
        expected = -1.0 if rule.mirrored else 1.0
        sign = expected if self.sign.decode(v, around) else -expected
        near = tuple(sum(self.kept[u][i] for u in around) // len(around) if around else 4096 for i in (0, 1))
        numbers = self.pairs.decode(near, tuple(whole_part(x * (16 / self.step)) for x in spread), source)
        self.kept[v] = tuple((5 * min(16 * abs(p), 2**17) + 3 * x) >> 3 for p, x in zip(numbers, near))
        return np.append(ATTR_24_point(*(centre + self.step * vector(*numbers)), *frame), sign)
