"""DELT-7: planned cycles. `alone` tells which anchors are the only ones of their components."""
import numpy as np

from container import must
from graph import components
from levels import DELT_7_add_levels, Level, count_edges

def dot(p, q):  # DELT-7
    return (p * q).sum(axis=0)

def quotient(p, q):  # DELT-7
    return np.divide(p, q, out=np.zeros(3), where=q > 0)

def DELT_7_sweep(level, x, s, b, t, g):
    for i, (near, w) in enumerate(level.A.rows):
        if len(near):
            s[i] = (t[i] + w @ s[near]) / level.d[i]
            x[i] = (b[i] + w @ x[near] - level.M[i] * s[i]) / level.d[i]
        else:
            x[i], s[i] = g[level.at.index(i)], b[i] / level.M[i]

def DELT_7_cycle(level, b, t, g, alone):
    """x, s and f."""
    x, s, f = np.zeros((level.n, 3)), np.zeros((level.n, 3)), np.zeros(g.shape)
    DELT_7_sweep(level, x, s, b, t, g)
    down, up, kept = level.P.transposed_times, level.P.times, level.next.kept
    gaps, lone = (g - x[level.at])[kept], alone[kept]
    u, v, f[kept] = DELT_7_solve(level.next, down(b - level.K(x) - level.M * s), down(t - level.K(s)), gaps, lone)
    x, s = x + up(u), s + up(v)
    DELT_7_sweep(level, x, s, b, t + level.pull(f), g)
    return x, s, f

def DELT_7_conjugate_gradients(N, r):
    d, lower, x = np.diag(N)[:, None], np.linalg.inv(np.tril(N)), np.zeros(r.shape)
    z = p = lower.T @ (d * (lower @ r))
    for _ in range(12):
        before = dot(r, z)
        a = quotient(before, dot(p, N @ p))
        x, r = x + a * p, r - a * (N @ p)
        z = lower.T @ (d * (lower @ r))
        p = z + p * quotient(dot(r, z), before)
    return x

def DELT_7_coarsest(level, b, t, g, alone):
    K, E, M = level.K(np.eye(level.n)), level.pull(np.eye(len(g))), level.M
    N, right = K @ (K / M) + E @ E.T, K @ (b / M) - t + E @ g
    x = np.linalg.solve(N, right) if level.n < 200 else DELT_7_conjugate_gradients(N, right)
    return x, (b - K @ x) / M, np.where(alone, 0, E.T @ x - g)

def DELT_7_solve(level, b, t, g, alone, is_second=False):
    if not level.next:
        return DELT_7_coarsest(level, b, t, g, alone)
    total, count = 0, 1 if is_second or 2 * count_edges(level.next.edges) > count_edges(level.edges) else 2
    for _ in range(count):
        x, s, f = DELT_7_cycle(level, b, t, g, alone)
        Kx, at = level.K(x), level.at
        l = quotient(dot(Kx, b / level.M) - dot(x, t) + dot(x[at], g), dot(Kx, Kx / level.M) + dot(x[at], x[at]))
        b, t, g = b - l * (Kx + level.M * s), t - l * (level.K(s) - level.pull(f)), g - l * (x[at] - f)
        total += np.vstack([x, s, f]) * l
    return np.split(total, [level.n, 2 * level.n])

def DELT_7_positions(graph, deltas, places, cycles):
    """The positions of the solved vertices relative to the centre; `places` are those of the anchors, by their vertices."""
    at = sorted(places)
    held = [[a for a in part if a in places] for part in components(graph)]
    alone, c = np.isin(at, [part[0] for part in held if len(part) == 1])[:, None], np.array([places[a] for a in at])
    finest = Level([dict.fromkeys(row, 1) for row in graph], np.array([[len(row)**2] for row in graph]), at)
    DELT_7_add_levels([finest])
    must(finest.next, "DELT-7", "cycles without a second level")
    d, second, P = finest.d, finest.next, finest.P
    S, F = np.zeros((second.n, 3)), np.zeros((len(at), 3))

    def correction(r, g):
        nonlocal S, F
        u, s, f = DELT_7_solve(second, P.transposed_times(r), second.pull(F) - second.K(S), g + F, alone, True)
        S, F = S + s, F + f
        return P.times(u)

    def sweeps(x, *over):
        """Sweeps x, and returns the residual."""
        right = d * deltas - d**2 * P.times(S)
        for w in over:
            for i, (near, ones) in enumerate(finest.A.rows):
                x[i] += w / d[i] * (right[i] + ones @ x[near] - d[i] * x[i])
        return right - finest.K(x)

    x = correction(d * deltas, c)
    for _ in range(cycles):
        r = sweeps(x, 1.3, 1)
        x += correction(r, c - x[at])
    sweeps(x, 1, 1)
    return x
