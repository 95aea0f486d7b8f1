"""DELT-7: planned cycles on the levels of a group."""
import numpy as np

from levels import DELT_7_levels

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
