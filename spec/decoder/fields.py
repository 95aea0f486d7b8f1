"""Fields, vectors of whole numbers at the vertices of a graph: compact.md, FLD-1 to FLD-8; and ATTR-9."""
from coder import CMP_9_ratio, bits, clamp, mixing_weights, symbol_models
from container import must
from scaled import FLD_5_near, FLD_5_quantity, SYMBOL_WEIGHTS, ScaledCoder

PAIRS = ((0, 0), (0, 1), (0, 2), (1, 1), (1, 2))

class FieldCoder:
    """`graph` has the neighbours of each vertex; `start(v)` is the first vertex of its walk."""
    def __init__(self, coder, graph, axes, start=lambda v: 0):
        self.coder, self.graph, self.axes = coder, graph, axes
        self.coded = [[u for u in around[:16] if start(v) <= u < v] for v, around in enumerate(graph)]
        self.A, self.B = [0, 65536, 65536], [0, 0, 0]
        self.models, self.weights, self.scaled = symbol_models(SYMBOL_WEIGHTS), mixing_weights(3), ScaledCoder()
        self.r, self.sizes, self.products = {}, {}, {}

    def FLD_3_mean(self, v, of):
        around = self.coded[v]
        c = max(len(around), 1)
        return [(sum(x) * ((65536 + c // 2) // c)) >> 16 for x in zip(*(of(u) for u in around))] or [0] * 5

class FieldVertex:
    """A vertex that is being coded; a hint [FLD-7] is a pair of spreads E and offsets o."""
    def __init__(self, field, v, hint=None):
        self.field, self.v, self.r, self.q, self.forecasts = field, v, [], [], []
        self.R = field.FLD_3_mean(v, lambda u: [16 * x for x in field.r[u]])
        self.G, self.M = field.FLD_3_mean(v, field.sizes.get), field.FLD_3_mean(v, field.products.get)
        self.sizes = [(4 * G + 5 * E) >> 3 for G, E in zip(self.G, hint[0])] if hint else self.G
        self.spread, self.offset = hint or (self.G, [0] * 3)

    def FLD_4_regression(self, a):
        if a == 0:
            return 0
        M00, M01, M02, M11, M12 = self.M
        yx, zx, r = CMP_9_ratio(M01, M00 + 5), CMP_9_ratio(M02, M00 + 5), self.r
        if a == 1:
            return (yx * r[0]) >> 8
        yy, yz = max(M11 - ((yx * M01) >> 12), 0), M12 - ((yx * M02) >> 12)
        return ((zx * r[0]) >> 8) + ((CMP_9_ratio(yz, yy + 5) * (16 * r[1] - ((yx * r[0]) >> 8))) >> 12)

    def FLD_4_forecast(self, a):
        """Mean, scale, reg and coded."""
        field, r, G = self.field, self.r, self.sizes
        reg, coded = self.FLD_4_regression(a), (0, 16 * abs(r[0]) if a else 0, 8 * sum(map(abs, r)))[a]
        mean = ((field.A[a] * reg + field.B[a] * self.R[a]) >> 16) + self.offset[a]
        total = sum(G[:3])
        scale = (78 * G[0] + 15 * total) >> 7 if a == 0 else (64 * G[a] + 13 * total + 12 * coded) >> 7
        self.forecasts.append((mean, scale + 1, reg))
        return mean, scale + 1, coded

    def FLD_5_context(self, a):
        """Models, key of weights, shift, and whether the sign is swapped."""
        (mean, scale, coded), Q = self.FLD_4_forecast(a), FLD_5_quantity
        shift = max(bits(scale) - 6, 0)
        s, near, D = scale >> shift, min(abs(mean) >> shift, 255), clamp(len(self.field.graph[self.v]), 3, 10) - 3
        u, S, d = FLD_5_near(near, s), Q(s) + (4 if shift else 0), clamp(D, 1, 5) - 1
        t = 0 if u == 0 else 1 if u < 3 else 2
        models = [self.field.models[0, (S * 6 + u) * 5 + d],
                  self.field.models[1, ((Q(coded >> shift) * 8 + D) * 3 + a) * 3 + t],
                  self.field.models[2, ((Q(self.spread[a] >> shift) * 3 + min(near // 16, 2)) * 5 + d) * 3 + a]]
        return models, S // 4 * 3 + a, shift, mean < 0

    def number(self, a, context, weights):
        models, _, shift, swapped = context
        x = self.field.scaled.CMP_15_number(self.field.coder, models, weights, shift)
        must(abs(x) <= 2**30, "FLD-1", f"number {x}")
        self.q.append(-x if swapped else x)
        self.r.append(clamp(self.q[-1], -8191, 8191))

    def FLD_2_remember(self):
        self.r += [0] * (3 - len(self.r))
        f = [clamp(x, -2047, 2047) for x in self.q] + [0] * (3 - len(self.q))
        def smooth(values, means):
            return [(5 * x + 3 * y) >> 3 for x, y in zip(values, means)] if self.field.coded[self.v] else values
        self.field.r[self.v] = self.r
        self.field.sizes[self.v] = smooth([16 * abs(x) for x in self.r], self.G)
        self.field.products[self.v] = smooth([16 * f[a] * f[b] for a, b in PAIRS], self.M)

    def FLD_4_learn(self):
        A, B = self.field.A, self.field.B
        for a, (mean, scale, reg) in enumerate(self.forecasts):
            e = 16 * self.r[a] - mean
            step = 128 if e > scale >> 1 else -128 if e < -(scale >> 1) else 0
            if abs(reg) > scale >> 2 and a:
                A[a] = clamp(A[a] + (step if reg > 0 else -step), -4 * 65536, 4 * 65536)
            if abs(self.R[a]) > scale >> 2:
                B[a] = clamp(B[a] + (step if self.R[a] > 0 else -step), -4 * 65536, 4 * 65536)

def FLD_8_step(field, vertices):
    """Codes one vertex, or one of each walk in turns; the weights learn from the first alone."""
    for a in range(field.axes):
        contexts = [vertex.FLD_5_context(a) for vertex in vertices]
        weights = [field.weights[context[1]] for context in contexts]
        weights[1:] = [list(w) for w in weights[1:]]
        for vertex, context, w in zip(vertices, contexts, weights):
            vertex.number(a, context, w)
    for vertex in vertices:
        vertex.FLD_2_remember()
    vertices[0].FLD_4_learn()
    return vertices[0].q

def FLD_8_two_walks(coder, graph):
    """The numbers of a field of three axes in two walks."""
    n = len(graph)
    m, q = n - n // 2, {}
    field = FieldCoder(coder, graph, 3, lambda v: 0 if v < m else m)
    for i in range(m):
        vertices = [FieldVertex(field, v) for v in (i, m + i) if v < (m if v == i else n)]
        FLD_8_step(field, vertices)
        q.update((vertex.v, vertex.q) for vertex in vertices)
    return [q[v] for v in range(n)]

def ATTR_9_means(coder, graph, axes):
    """A function that decodes the numbers of a vertex, which are predicted by means."""
    field, rows = FieldCoder(coder, graph, axes), []
    def decode(v):
        around, hint = field.coded[v], None
        p = rows[v - 1] if v else [0] * 3
        if around:
            c, columns = len(around), list(zip(*(rows[u] for u in around)))
            p = [(2 * sum(x) + c) // (2 * c) for x in columns]
            hint = ([16 * sum(min(abs(x - y), 8191) for x in column) // c for column, y in zip(columns, p)],
                    [16 * sum(column) // c - 16 * y for column, y in zip(columns, p)])
        q = FLD_8_step(field, [FieldVertex(field, v, hint)])
        rows.append([x + y for x, y in zip(p, q + [0] * (3 - axes))])
        return rows[v]
    return decode
