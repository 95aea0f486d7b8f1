"""What texture coordinates and tangents share: the surface order [ATTR-30], blends [ATTR-35], pairs of numbers [ATTR-37]."""
from collections import deque

import numpy as np

from coder import ScaledCoder, bit_models, bits, clamp
from vectors import dot

def ATTR_30_order(surface):
    """Pairs of a vertex and the corners by which it completes faces, in their order."""
    visited, met, waits = [False] * surface.n, [0] * len(surface.faces), [0] * surface.n
    queue, stack, result = deque(), [], []

    def visit(v):
        if visited[v]:
            return
        visited[v], completed = True, []
        for f, a, b in surface.corners[v]:
            met[f] += 1
            if met[f] == 3:
                completed.append((f, a, b))
            elif met[f] == 2:
                for u in (u for u in (a, b) if not visited[u]):
                    (queue if waits[u] else stack).append(u)
                    waits[u] += 1
        result.append((v, completed))

    for face in surface.faces:
        for v in face:
            visit(v)
        while queue or stack:
            visit(queue.popleft() if queue else stack.pop())
    for v in range(surface.n):
        visit(v)
    return result

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
    o = bits(x + 4) - 3
    return min(2 * o + (((x + 4) >> (o + 1)) & 1), 19)

def whole_part(x):
    """Of a number, 0 to 2^17."""
    return int(clamp(x, 0, 2**17)) if x == x else 0

class PairCoder:
    """[ATTR-37] Two numbers."""
    def __init__(self, coder):
        self.coder, self.numbers, self.zero = coder, ScaledCoder(), bit_models()

    def decode(self, near, spread, kind):
        """`near` and `spread` are pairs."""
        if sum(near) < 4 and self.zero[min(bits(sum(spread)), 7)].decode(self.coder):
            return 0, 0
        p = self.number(0, near[0], spread[0], kind, 0)
        return p, self.number(1, near[1], spread[1], kind, abs(p))

    def number(self, second, near, spread, kind, t):
        scale, W = (8 * near + 6 * spread + 80 * t) >> 4, ATTR_37_log
        shift = max(bits(scale) - 7, 0)
        c = 1 + min(t >> shift, 3) if second else 0
        first, other = (W(near >> shift) * 5 + kind) * 5 + c, (W(spread >> shift) * 2 + (shift > 0)) * 5 + c
        return self.numbers.CMP_15_number(self.coder, first, other, 2 * W(scale >> shift) + second, shift)
