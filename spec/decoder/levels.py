"""DELT-7: the levels of planned cycles. Vectors have a row for each node and a column for each axis."""
import numpy as np

class Matrix:
    """A sparse matrix of n columns; each row has its entries by their columns."""
    def __init__(self, rows, n):
        self.rows, self.n = [(np.array(list(row), dtype=int), np.array(list(row.values()), dtype=float)) for row in rows], n

    def times(self, x):
        return np.array([w @ x[columns] for columns, w in self.rows])

    def transposed_times(self, x):
        result = np.zeros((self.n, x.shape[1]))
        for (columns, w), value in zip(self.rows, x):
            result[columns] += w[:, None] * value
        return result

class Level:
    """`edges[i]` has the weight of the edge to each neighbour of node i; `at[a]` is the node of anchor a. P interpolates from the
    level `next`; the coarsest has none."""
    def __init__(self, edges, M, at):
        self.edges, self.M, self.at, self.n, self.next = edges, M, at, len(edges), None
        self.A, self.anchors = Matrix(edges, self.n), Matrix([{i: 1} for i in at], self.n)
        self.d = self.A.times(np.ones((self.n, 1)))

    def K(self, x):
        return self.d * x - self.A.times(x)

    def pull(self, f):
        """sum_a f_a e_a"""
        return self.anchors.transposed_times(f)

def DELT_7_add_levels(level):
    """Adds all that are coarser than this one."""
    seeds, edges = set(level.at), level.edges
    for i, row in enumerate(edges):
        if seeds.isdisjoint([i, *row]):
            seeds.add(i)
    if level.n < max(200, 5 * len(level.at)) or 5 * len(seeds) > min(4 * level.n, 5 * 2**28):
        return
    number = {i: c for c, i in enumerate(sorted(seeds))}
    home = [number[i if i in seeds else min(seeds.intersection(row))] for i, row in enumerate(edges)]
    level.P = Matrix([DELT_7_interpolation([i] if i in seeds else row, seeds, home) for i, row in enumerate(edges)], len(seeds))
    sums = [{} for _ in seeds]
    for i, row in enumerate(edges):
        for j, w in row.items():
            if home[i] != home[j]:
                before = sums[home[i]].get(home[j], 0)
                sums[home[i]][home[j]] = before + w * (2, 3, 6)[(i in seeds) + (j in seeds)] / 5
    level.next = Level(sums, level.P.transposed_times(level.M), [home[i] for i in level.at])
    DELT_7_add_levels(level.next)

def DELT_7_interpolation(neighbours, seeds, home):
    """The weights of nodes of the next level in a node with these neighbours; a seed counts as its own."""
    w = {}
    for j in neighbours:
        w[home[j]] = w.get(home[j], 0) + (4 if j in seeds else 1)
    best = sorted(w, key=lambda c: (-w[c], c))[:3]
    W = sum(w[c] for c in best)
    others = {c: (32 * w[c] + W) // (2 * W) / 16 for c in best[1:]}
    return {best[0]: 1 - sum(others.values())} | others
