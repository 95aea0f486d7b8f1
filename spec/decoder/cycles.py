"""DELT-7: planned cycles. Vectors have a row for each node and a column for each axis."""
import math

import numpy as np

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
    from graph import components
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

class Problem:
    """One group: its levels, and the solution of coupled problems on them."""
    def __init__(self, levels, maps, lonely, components):
        self.levels, self.maps, self.lonely, self.spent = levels, maps, lonely, 0
        self.ups = [m.times for m in maps]
        self.downs = [m.transposed().times for m in maps]
        self.twice, v, z = {}, 1, 0
        for k, level in enumerate(levels[1:-1], 1):
            self.twice[k] = z + 2 * v * level.work <= 4 * levels[0].work
            v *= 2 if self.twice[k] else 1
            z += v * level.work
        last = levels[-1]
        K, e = last.K.dense(), np.zeros(last.n)
        np.add.at(e, last.anchors, 1.0)
        self.N = (K / last.mass) @ K + np.diag(e)
        squares = sum((len(row) + 1)**2 for row in last.rows)
        self.exact = (last.n <= 200 or last.n <= 24 * components) and (squares <= 256 * last.n or squares <= 2**20)

    def coarsest(self, b, t, g):
        level = self.levels[-1]
        right = level.K.times(b / level.mass[:, None]) - t + level.forces(g)
        x = np.linalg.solve(self.N, right) if self.exact else self.conjugate_gradients(right)
        f = x[level.anchors] - g
        f[self.lonely] = 0
        return x, (b - level.K.times(x)) / level.mass[:, None], f

    def conjugate_gradients(self, right):
        n, N = self.levels[-1].n, self.N
        order = list(range(n))
        if n >= 2048:
            apart = [i for i in order[n // 2:] if not np.any(N[i, :n // 2])]
            order = order[:n // 2] + apart + sorted(set(order[n // 2:]) - set(apart))
        N, r, x = N[np.ix_(order, order)], right[order].copy(), np.zeros((n, 3))
        d, lower = np.diag(N)[:, None], np.linalg.inv(np.tril(N))
        y = lower @ r
        p, rho = lower.T @ (d * y), (d * y * y).sum(axis=0)
        goal, most = 1e-6 * rho, min(max(int(max(600 * self.levels[0].n - self.spent, 0) // n), 4), 200)
        for iteration in range(1, most + 1):
            q = N @ p
            alpha = np.divide(rho, (p * q).sum(axis=0), out=np.zeros(3), where=rho > 0)
            x, r = x + alpha * p, r - alpha * q
            y, before = lower @ r, rho
            rho = (d * y * y).sum(axis=0)
            self.spent += n
            if np.all(rho <= goal):
                break
            p = lower.T @ (d * y) + np.divide(rho, before, out=np.zeros(3), where=before > 0) * p
        result = np.zeros((n, 3))
        result[order] = x
        return result

    def cycle(self, k, b, t, g):
        level = self.levels[k]
        x, s = np.zeros((level.n, 3)), np.zeros((level.n, 3))
        level.sweep(x, s, b, t)
        down, up = self.downs[k], self.ups[k]
        coarse = down(b - level.K.times(x) - level.mass[:, None] * s), down(t - level.K.times(s)), g - x[level.anchors]
        dx, ds, f = self.solve(k + 1, *coarse)
        x, s = x + up(dx), s + up(ds)
        level.sweep(x, s, b, t + level.forces(f))
        return x, s, f

    def solve(self, k, b, t, g):
        """Solving a level: x, s and f."""
        if k == len(self.levels) - 1:
            return self.coarsest(b, t, g)
        first = x, s, f = self.cycle(k, b, t, g)
        if not self.twice[k]:
            return first
        level, M = self.levels[k], self.levels[k].mass[:, None]
        K, at = level.K.times, level.anchors
        def inner(p, q):
            return (K(p) * K(q) / M).sum(axis=0) + (p[at] * q[at]).sum(axis=0)
        def h(p, b, t, g):
            return (K(p) * b / M).sum(axis=0) - (p * t).sum(axis=0) + (p[at] * g).sum(axis=0)
        def quotient(p, q):
            return np.divide(p, q, out=np.zeros(3), where=q > 0)
        xx = inner(x, x)
        l = quotient(h(x, b, t, g), xx)
        b, t, g = b - l * (K(x) + M * s), t - l * (K(s) - level.forces(f)), g - l * (x[at] - f)
        second = self.cycle(k, b, t, g)
        y = second[0]
        yx, yy = inner(y, x), inner(y, y)
        ratio = quotient(yx, xx)
        e = yy - ratio * yx
        more = np.where(e > 1e-6 * yy, quotient(h(y, b, t, g), e), 0.0)
        return tuple((l - ratio * more) * p + more * q for p, q in zip(first, second))

    def correction(self, r, g, over):
        """u on the second level."""
        b, c, second = self.downs[0](r), self.c, self.levels[1]
        u = np.zeros((second.n, 3))
        if c == 2:
            second.relax(u, b, over)
            b, g = self.downs[1](b - second.K.times(u)), g - u[second.anchors]
        level = self.levels[c]
        x, s, f = self.solve(c, b, level.forces(self.F) - level.K.times(self.S), g + self.F)
        self.S, self.F = self.S + s, self.F + f
        return u + (self.ups[1](x) if c == 2 else x)

    def run(self, deltas, places, cycles):
        """[DELT-7] The positions."""
        finest = self.levels[0]
        d, at = finest.degrees[:, None], finest.anchors
        self.c = 2 if len(self.levels) > 2 and self.levels[2].n >= 12 * len(at) else 1
        self.S, self.F = np.zeros((self.levels[self.c].n, 3)), np.zeros((len(at), 3))
        right = d * deltas
        x = self.ups[0](self.correction(right, places, [1.25]))
        first_alone = [self.maps[0].columns[np.argmax(self.maps[0].rows == i)] for i in range(finest.n)]
        for cycle in range(cycles + 1):
            s = self.ups[1](self.S) if self.c == 2 else self.S
            s = s[first_alone] if cycle == 0 else self.ups[0](s)
            b = right - d * d * s
            if cycle == cycles:
                finest.relax(x, b, [1.0, 1.0])
                return x
            finest.relax(x, b, [1.4, 1.2, 1.0] if cycles > 1 else [1.2, 1.0])
            x = x + self.ups[0](self.correction(b - finest.K.times(x), places - x[at], [1.4, 1.2]))

def DELT_7_depth(component, anchors, around):
    inner = {v for v in component if v in anchors and all(u in anchors for u in around[v])}
    v, a, depth = len(component) - len(inner), sum(u in anchors for u in component) - len(inner), 1
    v /= 16.8
    while v >= max(1.5, a):
        v, depth = v / 4.8, depth + 1
    return depth

def DELT_7_positions(large, anchors, around, of, cycles, dump):
    """Pairs of vertices and their positions, of the components of 8 vertices and more."""
    from delt import DELT_4_least_squares
    groups = {}
    for c in large:
        if len(c) <= 64:
            yield c, DELT_4_least_squares(*of(c))
        else:
            groups.setdefault(DELT_7_depth(c, anchors, around), []).append(c)
    for depth, members in groups.items():
        vertices = sorted(v for c in members for v in c)
        graph, deltas, places = of(vertices)
        nodes = sorted(places)
        levels, maps = DELT_7_levels(graph, nodes, depth)
        dump("levels", [(level.n, level.edges) for level in levels])
        for level, m in zip(levels, maps + [None]):
            dump("rows", level.rows)
            dump("interpolation", m and list(zip(m.rows, m.columns, m.values)))
        if len(levels) == 1:
            yield vertices, DELT_4_least_squares(graph, deltas, places)
            continue
        alone = {held[0] for c in members if len(held := [v for v in c if v in anchors]) == 1}
        lonely = np.array([vertices[v] in alone for v in nodes])
        problem = Problem(levels, maps, lonely, len(members))
        yield vertices, problem.run(deltas, np.array([places[v] for v in nodes]), cycles)
