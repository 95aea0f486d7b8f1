"""Joints and weights: attr_skin.md, ATTR-60 to ATTR-65."""
from collections import Counter

from attr import JOINTS, WEIGHTS
from attr_lattice import ATTR_58_copies
from coder import Coder, Mixture, NumberModel, clamp
from container import must, unzigzag
from lattice import PredictedCoder

def ATTR_60_joints(r, a, surface):
    coder, top = Coder(r), 256**int(a.type[1]) - 1
    first, known = surface.joined(coder.raw(1))
    rows = ATTR_58_copies(coder, first, JointCoder(coder, known, top).row, 4)
    must(all(0 <= j <= top for row in rows for j in row), "ATTR-60", "a joint of a copy is not of its type")
    return rows

class JointCoder:
    """[ATTR-61]"""
    def __init__(self, coder, known, top):
        self.coder, self.known, self.top, self.rows = coder, known, top, {}
        self.around, self.guesses = Mixture((6, 12, 4, 3, 2) + (1,) * 11), Mixture((16, 6, 4, 3, 2) + (1,) * 10 + (6,))
        self.steps, self.last = NumberModel(), 0

    def row(self, v):
        known = self.known[v]
        came = Counter(self.rows[u] for face in known.faces for u in face if u is not None)
        around = [row for row, _ in came.most_common()]
        row = self.known_row(around, came, known.count) if around else None
        self.rows[v] = row or self.new_row(around, came)
        return self.rows[v]

    def known_row(self, around, came, count):
        l = min(len(around), 7)
        d = came[around[0]] - (came[around[1]] if l > 1 else 0)
        s = self.coder.symbol(*self.around.of(5 * l + min(d, 4), 7 * l + min(count, 6), 0))
        return around[s - 1] if 1 <= s <= l else None

    def new_row(self, around, came):
        row, symbol = (), 0
        for s in range(4):
            points = Counter()
            for other in around:
                for j, joint in enumerate(other):
                    each = 4 if j != s else 48 if other[:s] == row else 16
                    points[joint] += each * came[other]
            for joint in points:
                if joint in row and row[s - 1] != joint:
                    points[joint] //= 32
            guesses = [joint for joint, _ in points.most_common(14)]
            c, e = len(guesses), 3
            if c >= 2:
                e = sum(points[guesses[0]] >= k * points[guesses[1]] for k in (2, 4))
            symbol = self.coder.symbol(*self.guesses.of(16 * s + 4 * min(c, 3) + e, 16 * s + symbol, 0))
            row += (guesses[symbol] if symbol < c else self.other(),)
        return row

    def other(self):
        self.last += unzigzag(self.steps.decode(self.coder))
        must(0 <= self.last <= self.top, "ATTR-60", f"joint {self.last}")
        return self.last

def ATTR_62_joints(a, surface):
    """The joints of every vertex that go with these weights."""
    before = sum(b.kind == WEIGHTS for b in surface.attributes[:surface.attributes.index(a)])
    joints = [b for b in surface.attributes if b.kind == JOINTS][before:before + 1]
    if joints and joints[0].is_shape(JOINTS, ["u1", "u2"], [4]):
        return [tuple(row) for row in joints[0].values.tolist()]
    return [(0, 1, 2, 3)] * surface.n

def ATTR_63_weights(r, a, surface):
    total = r.varint(65536, "CON-2")
    full = {"u1": 255, "u2": 65535}.get(a.type)
    must(total >= 1, "ATTR-63", "sum 0")
    must(not full or full % total == 0, "ATTR-63", f"sum {total} does not divide {full}")
    coder, joints = Coder(r), ATTR_62_joints(a, surface)
    first, known = surface.joined(coder.raw(1))
    weights = WeightCoder(coder, known, [joints[v] for v in first[:-1]], total)
    rows = ATTR_58_copies(coder, first, weights.decode, 3)
    rows = [tuple(row) + (total - sum(row),) for row in rows]
    must(all(0 <= w <= total for row in rows for w in row), "ATTR-63", "a weight is not 0 to the sum")
    return [[w * (full // total) if full else w / total for w in row] for row in rows]

class WeightCoder(PredictedCoder):
    """[ATTR-64, ATTR-65]"""
    def __init__(self, coder, known, joints, total):
        super().__init__(coder, known, [(60, 0)] * 24, [total] * 3)
        self.joints, self.total = joints, total
        self.ends = Mixture((10, 6, 10) + (1,) * 13)

    def row(self, u, v):
        """[ATTR-64] What u gives to the joints of v's first three slots."""
        weights = self.rows[u] + [self.total - sum(self.rows[u])]
        return [sum(w for w, j in zip(weights, self.joints[u]) if j == joint) for joint in self.joints[v][:3]]

    def read(self, v, x):
        """[ATTR-65]"""
        known, s, rest, whole = self.known[v], x.axis, self.total - sum(self.rows[v]), x.whole
        if s == 0:
            self.symbols = [0, 0]
        if rest == 0:
            return 0
        symbol = self.end(known, v, s, whole, rest)
        if symbol < 2:
            return (0, rest)[symbol]
        around = [self.row(u, v)[s] for face in known.faces for u in face if u is not None]
        around = [w for w in around if 0 < w < self.total]
        w = self.FLT_4_guess(known, x, around, whole)
        if w is None:
            w = clamp(whole, 1, max(rest - 1, 1)) + self.POSN_6_number(x)
        must(0 < w < rest, "ATTR-65", f"weight {w}")
        return w

    def share(self, x):  # ATTR-65: S(x)
        return 1 + sum(k * x > self.total for k in (64, 16, 4))

    def end(self, known, v, s, whole, rest):  # ATTR-65
        around, joints = [self.row(u, v)[s] for u in known.corners], self.joints[v]
        nothing = around.count(0)
        e = 4 if not around else 0 if not nothing else 3 if nothing == len(around) else 1 if 2 * nothing <= len(around) else 2
        f = 0 if whole >= rest else self.share(rest - whole)
        k = 3 * self.symbols[-2] + self.symbols[-1]
        first = ((5 * s + e) * 5 + f) * 2 + (joints[s] in joints[:s])
        second = (9 * s + k) * 6 + min(self.share(whole) + (whole > 0), 5)
        self.symbols.append(min(self.coder.symbol(*self.ends.of(first, second, 0)), 2))
        return self.symbols[-1]
