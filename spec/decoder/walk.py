"""The surface walk [ATTR-30], blends [ATTR-35] and pairs of numbers [ATTR-37] of texture coordinates and tangents."""
from coder import bit_models, bits, mixing_weights, symbol_models
from container import must
from graph import corners, others
from scaled import SYMBOL_WEIGHTS, ScaledCoder

def ATTR_30_walk(faces, n):
    """Pairs of a vertex and the corners by which it completes faces, in the order of the walk."""
    at, visited, met, waits = corners(faces, n), [False] * n, [0] * len(faces), [0] * n
    queue, stack, result, head = [], [], [], 0

    def visit(v):
        visited[v], completed = True, []
        for corner in at[v]:
            met[corner // 3] += 1
            if met[corner // 3] == 3:
                completed.append(corner)
            elif met[corner // 3] == 2:
                for u in others(faces, corner):
                    if not visited[u]:
                        (queue if waits[u] else stack).append(u)
                        waits[u] += 1
        result.append((v, completed))

    for face in faces:
        for v in face:
            if not visited[v]:
                visit(v)
        while head < len(queue) or stack:
            if head < len(queue):
                v, head = queue[head], head + 1
            else:
                v = stack.pop()
            if not visited[v]:
                visit(v)
    for v in range(n):
        if not visited[v]:
            visit(v)
    return result

def dot2(x, y):
    return x[0] * y[0] + x[1] * y[1]

def cross2(x, y):
    return x[0] * y[1] - x[1] * y[0]

def sub2(x, y):
    return x[0] - y[0], x[1] - y[1]

class Blend:
    """[ATTR-35]"""
    def __init__(self):
        self.X11 = self.X12 = self.X22 = self.Y1 = self.Y2 = 0.0

    def correction(self, d1, d2):
        a, c, b = self.X11 + 0.02, self.X22 + 0.02, self.X12
        D, w1, w2 = a * c - b * b, 0.0, 0.0
        if D > 0:
            h = 1 / D
            w1, w2 = h * (c * self.Y1 - b * self.Y2), h * (a * self.Y2 - b * self.Y1)
        return w1 * d1[0] + w2 * d2[0], w1 * d1[1] + w2 * d2[1]

    def learn(self, d1, d2, e, g):
        self.X11, self.X12 = 0.99 * self.X11 + g * dot2(d1, d1), 0.99 * self.X12 + g * dot2(d1, d2)
        self.X22 = 0.99 * self.X22 + g * dot2(d2, d2)
        self.Y1, self.Y2 = 0.99 * self.Y1 + g * dot2(d1, e), 0.99 * self.Y2 + g * dot2(d2, e)

class BitOfFaces:
    """[ATTR-36, ATTR-43] A bit whose model tells which values it had at the corners a and b of completed faces."""
    def __init__(self, coder):
        self.coder, self.models, self.had = coder, bit_models(), {}

    def decode(self, v, around):
        had = [self.had[u] for u in around if u in self.had]
        self.had[v] = self.models[(0 in had) + 2 * (1 in had)].decode(self.coder)
        return self.had[v]

def ATTR_37_log(x):
    """W"""
    y = x + 4
    o = bits(y) - 3
    return min(2 * o + ((y >> (o + 1)) & 1), 19)

def at_most(x, most):
    """The whole part of a double that is not negative."""
    return most if x >= most else int(x) if x > 0 else 0

class PairCoder:
    """[ATTR-37] Two numbers."""
    def __init__(self, coder):
        self.coder, self.scaled, self.zero = coder, ScaledCoder(), bit_models()
        self.models, self.weights = symbol_models(SYMBOL_WEIGHTS), mixing_weights(3)

    def decode(self, near, spread, kind):
        """`near` and `spread` are pairs."""
        if sum(near) < 4 and self.zero[min(bits(sum(spread)), 7)].decode(self.coder):
            return 0, 0
        p = self.number(0, near[0], spread[0], kind, 0)
        return p, self.number(1, near[1], spread[1], kind, abs(p))

    def number(self, second, near, spread, kind, t):
        scale = (8 * near + 6 * spread + 80 * t) >> 4
        shift = max(bits(scale) - 7, 0)
        c = 1 + min(t >> shift, 3) if second else 0
        W = ATTR_37_log
        models = [self.models[0, (W(near >> shift) * 5 + kind) * 5 + c],
                  self.models[1, (W(spread >> shift) * 2 + (shift > 0)) * 5 + c],
                  self.models[2, (W(scale >> shift) * 2 + (kind > 1)) * 5 + c]]
        x = self.scaled.FLD_5_number(self.coder, models, self.weights[2 * W(scale >> shift) + second], shift,
                                     min(shift, 3) * 2 + second)
        must(abs(x) <= 2**24, "ATTR-37", f"number {x}")
        return x
