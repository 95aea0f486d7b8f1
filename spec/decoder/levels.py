"""DELT-7: the levels of one component. Vectors have a row for each node and a column for each axis."""
from logging import debug

import numpy as np

class Matrix:  # DELT-7
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

class Level:  # DELT-7
    """`edges[i]` has the weight of the edge to each neighbour of node i; `at[k]` is the node of the k-th anchor. P interpolates from the
    level `next`; the coarsest has none."""
    def __init__(self, edges, M, at):
        self.edges, self.M, self.at, self.n, self.next = edges, M, at, len(edges), None
        self.A, self.anchors = Matrix(edges, self.n), Matrix([{i: 1} for i in at], self.n)
        self.d = self.A.times(np.ones((self.n, 1)))
        debug("level: %s nodes, of anchors %s\nedges by node: %s\nmasses: %s", self.n, at, edges, M[:, 0])

    def K(self, x):
        return self.d * x - self.A.times(x)

    def pull(self, f):
        """sum_a f_a e_a"""
        return self.anchors.transposed_times(f)

def count_edges(edges):  # DELT-7
    return sum(map(len, edges)) // 2

def DELT_7_add_levels(levels):
    """Adds all that are coarser than the last of these."""
    level, is_finest = levels[-1], len(levels) == 1
    edges, seeds = level.edges, {*level.at, *(i for i, row in enumerate(level.edges) if is_finest and len(row) > 24)}
    for i, row in enumerate(edges):
        if seeds.isdisjoint([i, *row]):
            seeds.add(i)
    if level.n < 200 or not is_finest and (level.n < 5 * len(level.at) or 5 * len(seeds) > 4 * level.n):
        return
    number = {i: c for c, i in enumerate(sorted(seeds))}
    home = [number[i if i in seeds else min(seeds.intersection(row))] for i, row in enumerate(edges)]
    rows = [DELT_7_interpolation([i] if i in seeds else row, seeds, home) for i, row in enumerate(edges)]
    if len(levels) < 3:
        coarse = DELT_7_paths(edges, seeds, home, 1 / 5 if is_finest else 0.185)
    else:
        coarse = DELT_7_product(edges, level.d[:, 0], rows, len(seeds))
    if count_edges(coarse) > count_edges(levels[0].edges):
        return
    debug("interpolation by node: %s", rows)
    level.P = Matrix(rows, len(seeds))
    level.next = Level(coarse, level.P.transposed_times(level.M), [home[i] for i in level.at])
    DELT_7_add_levels([*levels, level.next])

def DELT_7_paths(edges, seeds, home, unit):
    """The edges of the second or the third level."""
    sums = [{} for _ in seeds]
    for i, row in enumerate(edges):
        for j, w in row.items():
            if home[i] != home[j]:
                before = sums[home[i]].get(home[j], 0)
                sums[home[i]][home[j]] = before + unit * w * (2, 3, 6)[(i in seeds) + (j in seeds)]
    return sums

def DELT_7_product(edges, d, rows, n):
    """The edges of P^T K P."""
    sums = [{} for _ in range(n)]
    for i, row in enumerate(edges):
        for j, w in [(i, -d[i]), *row.items()]:
            for c, p in rows[i].items():
                for other, q in rows[j].items():
                    if c != other:
                        sums[c][other] = sums[c].get(other, 0) + p * w * q
    return sums

def DELT_7_interpolation(neighbours, seeds, home):
    """The weights of nodes of the next level in a node with these neighbours; a seed counts as its own."""
    w = {}
    for j in neighbours:
        w[home[j]] = w.get(home[j], 0) + (4 if j in seeds else 1)
    best = sorted(w, key=lambda c: (-w[c], c))[:3]
    W = sum(w[c] for c in best)
    others = {c: (32 * w[c] + W) // (2 * W) / 16 for c in best[1:]}
    return {c: p for c, p in ({best[0]: 1 - sum(others.values())} | others).items() if p > 0}
