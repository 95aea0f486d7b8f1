"""What texture coordinates and tangents share: the surface order [ATTR-30], bits [ATTR-36], pairs of numbers [ATTR-37]."""
from collections import deque

from coder import ScaledCoder, bit_models, bits, clamp, log4

def ATTR_30_order(surface):
    """Of each vertex in its order: it, the corners by which it completes faces, a and b of these, and the copy [ATTR-36] or None."""
    visited, met, waits = [False] * surface.n, [0] * len(surface.faces), [0] * surface.n
    queue, stack, result, latest = deque(), [], [], {}

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
        g, around = surface.geometric[v], [u for _, a, b in completed for u in (a, b)]
        result.append((v, completed, around, latest.get(g)))
        latest[g] = v

    for face in surface.faces:
        for v in face:
            visit(v)
        while queue or stack:
            visit(queue.popleft() if queue else stack.pop())
    for v in range(surface.n):
        visit(v)
    return result

class BitOfFaces:
    """[ATTR-36, ATTR-43] A bit whose model tells which values it had at the corners a and b of completed faces."""
    def __init__(self, coder):
        self.coder, self.models, self.had = coder, bit_models(), {}

    def decode(self, v, around):  # ATTR-36, ATTR-43
        had = [self.had[u] for u in around if u in self.had]
        self.had[v] = self.models[(0 in had) + 2 * (1 in had)].decode(self.coder)
        return self.had[v]

def ATTR_37_class(x):
    return min((log4(x + 4) - 8) >> 1, 19)

def whole_part(x):  # ATTR-37, ATTR-44
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
        scale, of = (8 * near + 6 * spread + 80 * t) >> 4, ATTR_37_class
        shift = max(bits(scale) - 7, 0)
        c = 1 + min(t >> shift, 3) if second else 0
        first, other = (of(near >> shift) * 5 + kind) * 5 + c, (of(spread >> shift) * 2 + (shift > 0)) * 5 + c
        return self.numbers.CMP_15_number(self.coder, first, other, 2 * of(scale >> shift) + second, shift)
