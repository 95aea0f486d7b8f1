"""DELT-7: the levels of planned cycles. Vectors have a row for each node and a column for each axis."""
import math

import numpy as np

from graph import components

class Matrix:
    """A sparse matrix by its entries."""
    def __init__(self, rows, columns, values, shape):
        self.rows, self.columns, self.values = np.array(rows, dtype=int), np.array(columns, dtype=int), np.array(values, dtype=float)
        self.shape = shape

    def times(self, x):
        result = np.zeros((self.shape[0],) + x.shape[1:])
        np.add.at(result, self.rows, self.values.reshape((-1,) + (1,) * (x.ndim - 1)) * x[self.columns])
        return result

    def transposed(self):
        return Matrix(self.columns, self.rows, self.values, self.shape[::-1])

    def dense(self):
        result = np.zeros(self.shape)
        np.add.at(result, (self.rows, self.columns), self.values)
        return result

class Level:
    """`rows[i]` lists pairs of a neighbour and an edge's weight; `anchors[a]` is the node of anchor a."""
    def __init__(self, rows, mass, anchors):
        self.rows, self.mass, self.anchors, self.n = rows, np.array(mass, dtype=float), anchors, len(rows)
        self.edges = sum(map(len, rows)) // 2
        self.work = self.n + 2 * self.edges
        self.degrees = np.array([sum(w for _, w in row) for row in rows], dtype=float)
        at = [(i, j, -w) for i, row in enumerate(rows) for j, w in row] + [(i, i, d) for i, d in enumerate(self.degrees)]
        self.K = Matrix(*zip(*at), (self.n, self.n))
        self.lists = [(np.array([j for j, _ in row], dtype=int), np.array([w for _, w in row])) for row in rows]

    def forces(self, f):
        """sum_a f_a e_a"""
        result = np.zeros((self.n, 3))
        np.add.at(result, self.anchors, f)
        return result

    def sweep(self, x, s, b, t):
        """Of the coupled problem."""
        for i, (near, w) in enumerate(self.lists):
            if len(near):
                s[i] = (t[i] + w @ s[near]) / self.degrees[i]
                x[i] = (b[i] + w @ x[near] - self.mass[i] * s[i]) / self.degrees[i]
            else:
                s[i] = b[i] / self.mass[i]

    def relax(self, x, b, over):
        """Over-relaxed sweeps for K x = b, one for each number."""
        for factor in over:
            for i, (near, w) in enumerate(self.lists):
                if len(near):
                    x[i] += factor / self.degrees[i] * (b[i] + w @ x[near] - self.degrees[i] * x[i])

def DELT_7_seeds(level):
    """The seeds, and for every node the number of the node of the next level that it belongs to."""
    count = [len(row) for row in level.rows]
    hubs = {i for i in range(level.n) if count[i] * level.n > 2 * sum(count)}
    anchors = set(level.anchors)
    seeds = anchors | hubs
    for i in range(level.n):
        if i not in seeds and not any(j in seeds and j not in hubs for j, _ in level.rows[i]):
            seeds.add(i)
    number = {i: k for k, i in enumerate(sorted(seeds))}
    def home(i):
        near = [j for j, _ in level.rows[i] if j in seeds and j not in hubs]
        return min([j for j in near if j in anchors] or near)
    return seeds, [number[i if i in seeds else home(i)] for i in range(level.n)]

def DELT_7_interpolation(level, seeds, belongs, is_finest):
    """For every node the nodes of the next level that it is interpolated from, with their sixteenths."""
    result, left = [], sum(map(len, level.rows))
    for i, row in enumerate(level.rows):
        left -= len(row)
        if i in seeds:
            result.append([(belongs[i], 16)])
            continue
        weights, F = {}, np.float32
        for j, w in row:
            weights[belongs[j]] = F(weights.get(belongs[j], F(0)) + F(w) * F(4 if j in seeds else 1))
        first_edge = not is_finest and len(row) <= 8 and left >= 8 - len(row)
        if first_edge:
            weights = {c: (F(w).view("u4") & np.uint32(0xfffffff8)).view("f4") for c, w in weights.items()}
            best = sorted(weights, key=lambda c: -weights[c])[:3]
        else:
            best = sorted(weights, key=lambda c: (-weights[c], c))[:3]
        W = F(0)
        for c in best:
            W = F(W + weights[c])
        parts = [math.floor(F(F(F(16) / W) * weights[c]) + F(0.5)) if not is_finest else
                 math.floor(16 * float(weights[c]) / float(W) + 0.5) for c in best[1:]]
        result.append([(c, p) for c, p in zip(best, [16 - sum(parts)] + parts) if p])
    return result

def DELT_7_bridges(level, seeds, belongs, count):
    """Rows of the next level."""
    m, members = [{} for _ in range(count)], [[] for _ in range(count)]
    for i, c in enumerate(belongs):
        members[c].append(i)
    for c, inside in enumerate(members):
        for i in sorted(inside, key=lambda i: (i not in seeds, i)):
            for j, _ in level.rows[i]:
                if belongs[j] != c:
                    kinds = m[c].setdefault(belongs[j], [0, 0, 0])
                    kinds[(i in seeds) + (j in seeds)] += 1
    rows = []
    for c, met in enumerate(m):
        order = [d for d in met if d < c] + [d for d in met if d > c][::-1]
        rows.append([(d, (6 * met[d][0] + 9 * met[d][1] + 18 * met[d][2]) / 16) for d in order])
    return rows

def DELT_7_product(level, P, count, keep_small):
    """Rows of the next level by P^T K P; and the number of its edges before small entries are left out."""
    entries, come_from = [{} for _ in range(count)], [[] for _ in range(count)]
    for i, parts in enumerate(P):
        for c, w in parts:
            come_from[c].append((i, w))
    for c, fine in enumerate(come_from):
        for i, w in fine:
            for j, k in [(i, level.degrees[i])] + [(j, -k) for j, k in level.rows[i]]:
                for d, v in P[j]:
                    entries[c][d] = entries[c].get(d, 0.0) + w * v * k / 256
    lists = [{d: v for d, v in row.items() if d != c and v < 0} for c, row in enumerate(entries)]
    edges = sum(map(len, lists)) // 2
    largest = [max((-v for v in row.values()), default=0.0) for row in lists]
    if not keep_small:
        lists = [{d: v for d, v in row.items() if not (-v < largest[c] / 10 and -v < largest[d] / 10)} for c, row in enumerate(lists)]
    return [[(d, -row[d]) for d in sorted(d for d in row if d < c)] + [(d, -v) for d, v in row.items() if d > c]
            for c, row in enumerate(lists)], edges

def DELT_7_next(level, is_finest, has_bridges, keep_small):
    """The next level and the interpolation from it, or None where there is none."""
    seeds, belongs = DELT_7_seeds(level)
    count, anchors = len(seeds), len(set(level.anchors))
    if count - anchors >= 0.8 * (level.n - anchors):
        return None
    P = DELT_7_interpolation(level, seeds, belongs, is_finest)
    if is_finest and has_bridges:
        rows = DELT_7_bridges(level, seeds, belongs, count)
    else:
        rows, edges = DELT_7_product(level, P, count, keep_small)
        if edges > level.edges:
            return None
    matrix = Matrix(*zip(*[(i, c, w / 16) for i, parts in enumerate(P) for c, w in parts]), (level.n, count))
    return Level(rows, matrix.transposed().times(level.mass), [belongs[i] for i in level.anchors]), matrix

def has_anchors(level):
    """Whether every component has one."""
    anchors = set(level.anchors)
    return all(anchors & set(c) for c in components([[j for j, _ in row] for row in level.rows]))

def DELT_7_levels(graph, anchors, depth, keep_small=False):
    """The levels, and the interpolation to each from the next."""
    levels, maps = [Level([[(j, 1) for j in row] for row in graph], [len(row)**2 for row in graph], anchors)], []
    while len(maps) < depth and sum(level.work for level in levels[:-1]) < 4 * levels[0].work:
        made = DELT_7_next(levels[-1], not maps, len(graph) >= 160 * len(anchors), keep_small)
        if made is None:
            break
        levels.append(made[0])
        maps.append(made[1])
    if not has_anchors(levels[-1]) and not keep_small:
        return DELT_7_levels(graph, anchors, depth, True)
    while not has_anchors(levels[-1]):
        levels.pop()
        maps.pop()
    return levels, maps
