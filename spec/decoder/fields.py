"""Fields, vectors of whole numbers at the vertices of a graph: compact.md, FLD-1 to FLD-15."""
from coder import bits, clamp, symbol_models
from container import must
from scaled import FLD_15_quantity, SYMBOL_WEIGHTS, ScaledCoder

PAIRS = ((0, 1), (0, 2), (1, 2))

def sign(x):
    return (x > 0) - (x < 0)

class FieldCoder:
    """`graph` has the neighbours of each vertex, ascending."""
    def __init__(self, coder, graph, axes):
        self.coder, self.graph, self.axes = coder, graph, axes
        self.models, self.scaled = symbol_models(SYMBOL_WEIGHTS), ScaledCoder()
        self.r, self.e = {}, {}

    def FLD_13_context(self, v):
        """R, G, E, T and L."""
        known = [u for u in self.graph[v][:4] if u < v]
        peers = [u for u in known if len(self.graph[u]) == len(self.graph[v])] or known
        if not peers:
            return [[0] * 3] * 5
        k, r = 12 // len(peers), [self.r[u] for u in peers]
        def tie(x, y):
            return min(abs(x), abs(y)) * (-1 if (x < 0) != (y < 0) else 1)
        return ([k * sum(x) for x in zip(*r)], [k * sum(map(abs, x)) for x in zip(*r)],
                [k * sum(x) for x in zip(*(self.e[u] for u in peers))],
                [k * sum(tie(x[a], x[b]) for x in r) for a, b in PAIRS], self.r[max(peers)])

    def FLD_14_vertex(self, v):
        """Decodes the numbers of a vertex."""
        R, G, E, T, L = self.FLD_13_context(v)
        close = 4 * sum(E) < sum(G)
        S, B = (E, L) if close else (G, [0] * 3)
        q, r = [], []
        for a in range(self.axes):
            d = [abs(x - y) for x, y in zip(r, B)]
            coded = 0 if a == 0 else 12 * d[0] if a == 1 else 6 * (d[0] + d[1])
            scale = ((8 * S[a] + sum(S) + 2 * coded) >> 4) + 1
            ties = sign(r[0]) * T[0] if a == 1 else sign(r[0]) * T[1] + sign(r[1]) * T[2] if a == 2 else 0
            mean = 0 if close else (R[a] >> 1) + ties
            x = self.FLD_15_number(v, a, S[a], coded, scale, mean, close)
            q.append(B[a] + (-x if mean < 0 else x))
            must(abs(q[a]) <= 2**30, "FLD-1", f"number {q[a]}")
            r.append(clamp(q[a], -8191, 8191))
        self.r[v] = r + [0] * (3 - self.axes)
        self.e[v] = [min(abs(x - y), 8191) for x, y in zip(self.r[v], L)]
        return q

    def FLD_15_number(self, v, a, S, coded, scale, mean, close):
        shift = max(bits(scale) - 6, 0)
        kind = 4 if close else sum(k * abs(mean) >= scale for k in (8, 2, 1))
        D = clamp(len(self.graph[v]), 3, 10) - 3
        def half(y):
            return FLD_15_quantity(y >> shift) // 2
        models = [self.models[0, FLD_15_quantity(scale >> shift) * 5 + kind],
                  self.models[1, ((half(coded) * 12 + half(S)) * 3 + a) * 8 + D]]
        return self.scaled.CMP_15_number(self.coder, models, [16497] * 2, shift)

def FLD_numbers(coder, graph):
    """The numbers of a field of three axes."""
    field = FieldCoder(coder, graph, 3)
    return [field.FLD_14_vertex(v) for v in range(len(graph))]
