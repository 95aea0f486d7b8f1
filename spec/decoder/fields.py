"""Fields, vectors of whole numbers at the vertices of a graph: compact.md, FLD-1 to FLD-15."""
from coder import ScaledCoder, bits, clamp, log4
from container import must

PAIRS = ((0, 1), (0, 2), (1, 2))

def sign(x):  # FLD-14
    return (x > 0) - (x < 0)

def FLD_15_quantity(x):
    """Q"""
    return min(log4(x + 4) - 8, 23)

class FieldCoder:  # FLD-13 to FLD-15
    """`graph` has the neighbours of each vertex, ascending."""
    def __init__(self, coder, graph):
        self.coder, self.graph, self.numbers = coder, graph, ScaledCoder()
        self.r, self.g, self.t, self.e = {}, {}, {}, {}

    def FLD_13_context(self, v):
        """R, G, T, E and L."""
        known = [u for u in self.graph[v][:4] if u < v]
        peers = [u for u in known if len(self.graph[u]) == len(self.graph[v])] or known
        if not known:
            return [[0] * 3] * 5
        def mean(rows, vertices, bits_off):
            return [(256 // len(vertices) * sum(x)) >> bits_off for x in zip(*(rows[u] for u in vertices))]
        return mean(self.r, known, 4), mean(self.g, known, 7), mean(self.t, known, 7), mean(self.e, peers, 7), self.r[max(peers)]

    def FLD_13_remember(self, v, r, G, T, E, L):
        def tie(x, y):
            return min(abs(x), abs(y)) * (-1 if (x < 0) != (y < 0) else 1)
        self.r[v] = r
        self.g[v] = [(16 * abs(x) + g) >> 2 for x, g in zip(r, G)]
        self.t[v] = [(16 * tie(r[a], r[b]) + t) >> 2 for (a, b), t in zip(PAIRS, T)]
        self.e[v] = [(16 * min(abs(x - l), 4095) + e) >> 2 for x, l, e in zip(r, L, E)]

    def FLD_14_vertex(self, v):
        """Decodes the numbers of a vertex."""
        R, G, T, E, L = self.FLD_13_context(v)
        close = 2 * sum(E) < sum(G)
        S, B = (E, L) if close else (G, [0] * 3)
        q, r = [], []
        for a in range(3):
            d = [abs(x - y) for x, y in zip(r, B)]
            coded = 0 if a == 0 else 16 * d[0] if a == 1 else 8 * (d[0] + d[1])
            scale = ((5 * S[a] + coded) >> 3) + 1
            ties = sign(r[0]) * T[0] if a == 1 else sign(r[0]) * T[1] + sign(r[1]) * T[2] if a == 2 else 0
            mean = ((R[a] - 16 * B[a]) >> 1) + (0 if close else ties)
            x = self.FLD_15_number(v, a, S[a], coded, scale, mean, close)
            q.append(B[a] + (-x if mean < 0 else x))
            must(abs(q[a]) <= 2**30, "FLD-1", f"number {q[a]}")
            r.append(clamp(q[a], -4095, 4095))
        self.FLD_13_remember(v, r, G, T, E, L)
        return q

    def FLD_15_number(self, v, a, S, coded, scale, mean, close):
        shift, near = max(bits(scale) - 6, 0), int(close)
        sure = sum(k * abs(mean) >= scale for k in (8, 2, 1))
        D = clamp(len(self.graph[v]), 3, 10) - 3
        def half(y):
            return FLD_15_quantity(y >> shift) // 2
        first = (FLD_15_quantity(scale >> shift) * 4 + sure) * 2 + near
        second = (((half(coded) * 12 + half(S)) * 3 + a) * 8 + D) * 2 + near
        return self.numbers.CMP_15_number(self.coder, first, second, a, shift)

def FLD_numbers(coder, graph):  # FLD-1, FLD-13 to FLD-15
    """The numbers of a field."""
    field = FieldCoder(coder, graph)
    return [field.FLD_14_vertex(v) for v in range(len(graph))]
