"""Colours of a surface: attr_colors.md, ATTR-45 to ATTR-52. The arithmetic is f32."""
import math

import numpy as np

from coder import Coder, Mixture, ScaledCoder, bits, clamp, log4
from container import must
from fields import FLD_15_quantity
from graph import neighbours
from vectors import F, square

ZERO, HALF = F(0), F(0.5)

def ATTR_45_colours(r, a, surface):
    level_bits, bound = r.u8(), r.number("H")
    must(level_bits in ((8,) if a.type == "u1" else (8, 16)), "ATTR-45", f"{level_bits} bits")
    must(bound <= (127 if level_bits == 8 else 32767), "ATTR-45", f"bound {bound}")
    top, sources, constants = 2**level_bits - 1, [], {}
    for c in range(a.k):
        source = r.u8()
        must(source in (c, 255) or source < c and sources[source] == source, "ATTR-45", f"source {source}")
        sources.append(source)
        if source == 255:
            constants[c] = r.number("H")
            must(constants[c] <= top, "ATTR-45", f"level {constants[c]}")
    axes = [c for c in range(a.k) if sources[c] == c]
    axes[:2] = axes[1::-1]
    rows = [[0] * 4] * surface.n
    if axes:
        number, former = surface.attributes.index(a), {}
        if surface.known:
            former = surface.known.MAP_30_former(number, surface.positions, level_bits)
        former = {v: F([levels[c] for c in axes] + [0] * (4 - len(axes))) for v, levels in former.items()}
        rows = ColourCoder(Coder(r), surface, number, len(axes), top, bound, former).decode()
    levels = [[constants[c] if s == 255 else row[axes.index(s)] for c, s in enumerate(sources)] for row in rows]
    return [[ATTR_46_value(x, a.type, level_bits) for x in row] for row in levels]

def ATTR_46_value(level, type_, level_bits):
    if type_ == "f4":
        return level / (2**level_bits - 1)
    return level * 257 if type_ == "u2" and level_bits == 8 else level

class ColourCoder:  # ATTR-45, ATTR-47 to ATTR-52, MAP-30
    """Colours, sizes and the like are vectors of the axes 0 to 3."""
    def __init__(self, coder, surface, attribute, axes, top, bound, former):
        self.coder, self.surface, self.axes, self.top, self.width = coder, surface, axes, F(top), 2 * bound + 1
        self.per_step, self.unit = F(16) / F(self.width), max(F(self.width), F(top) / F(255))
        self.former, self.before = former, []
        self.colours, self.sizes, self.outcomes, self.around = [], [], [], neighbours(surface.faces, surface.n)
        self.learnt = surface.states.models(
            ("colours", attribute), copies=Mixture((16, 6, 3, 30) + (1,) * 12), numbers=ScaledCoder())

    def decode(self):  # ATTR-47 to ATTR-51
        copies, first = self.coder.raw(1), self.surface.first
        for v, g in enumerate(self.surface.geometric):
            near = ([v - 1] if v > first[g] else []) + [u for u in self.around[v][:4] if u < v]  # [ATTR-47]
            shares = self.ATTR_47_shares(v, near)
            E = self.mix(near, shares, self.colours) if near else self.colours[v - 1] if v else np.zeros(4, dtype=F)
            F_v = self.former.get(v)
            if F_v is not None:  # [MAP-30]
                E = E + (F_v - self.mix(near, shares, self.before)) * F(0.6875) if near else F_v
            E = np.clip(E, ZERO, self.top)  # [ATTR-48]
            spread = self.mix(near, shares, {u: abs((d := self.colours[u] - E) - d[0] * F([0, 1, 1, 0])) for u in near})
            outcome, colour = 2 if near or not copies else 3, None
            if copies and (near or F_v is not None):
                outcome, colour = self.ATTR_50_copy(near, shares, F_v)
            self.ATTR_51_levels(colour, E, spread, self.mix(near, shares, self.sizes), bool(near))
            self.outcomes.append(outcome)
            self.before.append(self.colours[v] if F_v is None else F_v)
        return np.array(self.colours, dtype=np.int64).reshape(-1, 4).tolist()

    def ATTR_47_shares(self, v, near):
        positions, s = self.surface.positions, ZERO
        if positions is not None and near:
            distances = [square(positions[u] - positions[v]) for u in near]
            s = sum(distances, ZERO) / F(len(near))
        if not (np.isfinite(s) and s >= F(2**-126)):
            return [F(1) / F(max(len(near), 1))] * len(near)
        h = [F(1) / (d * (F(1) / s) + F(0.25)) for d in distances]
        total = sum((x * x for x in h), ZERO)
        return [x * x * (F(1) / total) for x in h]

    def mix(self, near, shares, of):  # ATTR-48, ATTR-49
        """The sum over the near vertices, with their shares as factors."""
        return sum((of[u] * share for u, share in zip(near, shares)), np.zeros(4, dtype=F))

    def ATTR_50_copy(self, near, shares, F_v):
        """The outcome, and the colour that is copied or None; `F_v`: the former colour [MAP-30], or None."""
        nearest = sorted(range(len(near)), key=lambda i: -shares[i])
        colours, t, farthest = [], [], ZERO
        if F_v is not None:
            colours, t = [F_v], [self.outcomes[near[nearest[0]]] if near else 3]
        for u in (near[i] for i in nearest):
            if all(np.any(self.colours[u] != colour) for colour in colours) and len(colours) < 3:
                colours.append(self.colours[u])
                t.append(self.outcomes[u])
        n, share = len(colours), sum((x for u, x in zip(near, shares) if not np.any(self.colours[u] != colours[0])), ZERO)
        for colour in colours[1:]:
            d = abs(colour - colours[0])
            farthest = max(farthest, (d[0] + d[1]) + (d[2] + d[3]))
        s, d = min(math.floor(F(8) * share), 7), min(bits(math.floor(farthest * (F(1) / self.unit))), 7)
        t += [3] * (3 - n)
        more = 0 if F_v is None else 192
        first, second = (8 * (n - 1) + s) * 8 + d, ((4 * t[0] + t[1]) * 4 + t[2]) * 3 + n - 1
        symbol = self.coder.symbol(*self.learnt.copies.of(more + first, more + second, 2 * (n - 1) + (t[0] == 0) + more // 32))
        return (min(symbol, 1), colours[symbol]) if symbol < n else (2, None)

    def ATTR_51_levels(self, colour, E, spread, before, has_near):
        """Decodes the levels where no colour is copied, and remembers what [ATTR-49] says."""
        levels, e, r, coded = np.zeros(4, dtype=F), [ZERO] * 4, [ZERO] * 4, ZERO
        size = before * HALF + spread * F(0.625)
        for a in range(self.axes):
            X = E[1] + e[0] if a == 1 else E[2] + (e[0] + e[1]) * HALF if a == 2 else E[a]
            X = min(max(X, ZERO), self.top)
            if a:
                coded = abs(r[0]) if a == 1 else (coded + abs(r[a - 1])) * HALF
            if colour is None:
                base = np.floor(X + HALF)
                q = clamp(self.ATTR_52_number(a, X, base, size, spread[a], coded), -2**17, 2**17)
                levels[a] = clamp(int(base) + self.width * q, 0, int(self.top))
            else:
                levels[a] = colour[a]
            e[a], r[a] = levels[a] - E[a], levels[a] - X
        self.colours.append(levels)
        self.sizes.append(abs(F(r)) * F(0.625) + before * F(0.375) if has_near else abs(F(r)))

    def ATTR_52_number(self, a, X, base, size, spread, coded):
        total = (size[0] + size[1]) + (size[2] + size[3])
        scale = (HALF * size[a] + F(0.1015625) * total) + F(0.09375) * coded
        if a == 0:
            scale = F(0.609375) * size[0] + F(0.1171875) * total
        def u(x):
            return math.floor(x * self.per_step)
        def K(x):
            return clamp(log4(math.floor(x * self.per_step + F(4))) - 8 - 4 * shift, 0, 23)
        whole = min(u(scale), 2**21 - 1) + 1
        shift = max(bits(whole) - 6, 0)
        s, near = whole >> shift, u(abs(X - base)) >> shift
        S = FLD_15_quantity(s) + (4 if shift else 0)
        e = sum(k <= (near * (2**20 // (s + 2))) >> 16 for k in (2, 5, 10, 16, 27))
        first, second = (6 * S + e) * 4 + a, (12 * (K(spread) // 2) + K(coded) // 2) * 4 + a
        q = self.learnt.numbers.CMP_15_number(self.coder, first, second, 4 * (S // 4) + a, shift)
        return -q if X < base else q
