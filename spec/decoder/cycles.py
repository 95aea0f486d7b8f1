"""DELT-7: planned cycles of one component."""
import numpy as np

from levels import DELT_7_add_levels, Level, count_edges

def dot(p, q):  # DELT-7
    return (p * q).sum(axis=0)

def quotient(p, q):  # DELT-7
    return np.divide(p, q, out=np.zeros(3), where=q > 0)

def DELT_7_sweep(level, x, s, b, t):
    for i, (near, w) in enumerate(level.A.rows):
        s[i] = (t[i] + w @ s[near]) / level.d[i]
        x[i] = (b[i] + w @ x[near] - level.M[i] * s[i]) / level.d[i]

def DELT_7_cycle(level, b, t, g):
    """x, s and f."""
    x, s = np.zeros((level.n, 3)), np.zeros((level.n, 3))
    DELT_7_sweep(level, x, s, b, t)
    down, up = level.P.transposed_times, level.P.times
    u, v, f = DELT_7_solve(level.next, down(b - level.K(x) - level.M * s), down(t - level.K(s)), g - x[level.at])
    x, s = x + up(u), s + up(v)
    DELT_7_sweep(level, x, s, b, t + level.pull(f))
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

def DELT_7_coarsest(level, b, t, g):
    K, E, M = level.K(np.eye(level.n)), level.pull(np.eye(len(g))), level.M
    N, right = K @ (K / M) + E @ E.T, K @ (b / M) - t + E @ g
    x = np.linalg.solve(N, right) if level.n < 200 else DELT_7_conjugate_gradients(N, right)
    return x, (b - K @ x) / M, E.T @ x - g if len(g) > 1 else np.zeros((1, 3))

def DELT_7_solve(level, b, t, g, is_second=False):
    if not level.next:
        return DELT_7_coarsest(level, b, t, g)
    total, count = 0, 1 if is_second or 2 * count_edges(level.next.edges) > count_edges(level.edges) else 2
    for _ in range(count):
        x, s, f = DELT_7_cycle(level, b, t, g)
        Kx, at = level.K(x), level.at
        l = quotient(dot(Kx, b / level.M) - dot(x, t) + dot(x[at], g), dot(Kx, Kx / level.M) + dot(x[at], x[at]))
        b, t, g = b - l * (Kx + level.M * s), t - l * (level.K(s) - level.pull(f)), g - l * (x[at] - f)
        total += np.vstack([x, s, f]) * l
    return np.split(total, [level.n, 2 * level.n])

def DELT_7_positions(graph, deltas, places, cycles):
    """The positions of a component relative to the centre; `places` are those of the anchors, by their vertices."""
    at = sorted(places)
    c = np.array([places[a] for a in at])
    finest = Level([dict.fromkeys(row, 1) for row in graph], np.array([[len(row)**2] for row in graph]), at)
    DELT_7_add_levels([finest])
    d, second = finest.d, finest.next
    if not second:
        return DELT_7_coarsest(finest, d * deltas, np.zeros((finest.n, 3)), c)[0]
    S, F, P = np.zeros((second.n, 3)), np.zeros((len(at), 3)), finest.P

    def correction(r, g):
        nonlocal S, F
        u, s, f = DELT_7_solve(second, P.transposed_times(r), second.pull(F) - second.K(S), g + F, True)
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
