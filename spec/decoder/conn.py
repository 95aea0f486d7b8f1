"""CONN: the faces over geometric vertices: conn.md."""
from coder import Coder, NumberModel, SymbolModel, bits, clamp, mixing_weights, symbol_models
from container import Reader, must

C, L, R, E, S, B, N = range(7)


class PlainOps:
    """[CONN-1, CONN-2, CONN-9, CONN-10] Ops and references of the plain form."""

    def __init__(self, data, m):
        self.reader = r = Reader(data)
        counts = [r.varint(len(data), "CONN-1") for _ in range(17)]
        references = r.varint(len(data), "CONN-1")
        far = r.varint(references, "CONN-1")
        self.glued = r.varint(3 * m, "CONN-11")
        must(m <= 32 * sum(counts), "CONN-2", "more faces than tokens can give")
        self.tokens = [list(r.bytes(count))[::-1] for count in counts]
        self.references = list(r.bytes(references))[::-1]
        self.far = r.planes(far)[::-1]
        self.run, self.last = 0, None

    def op(self, walk, t, gate, step):
        """[CONN-9]"""
        if self.run == 0 and self.last is None:
            full, closed = walk.full[t], walk.closed[t]
            if step == 1 and walk.loop_size(gate, 4) == 3 and full > 1 and not closed:
                stream = 16
            else:
                stream = min(full, 7) + (8 if step == 2 or closed else 0)
            must(self.tokens[stream], "CONN-9", f"stream {stream} has no token left")
            code, k = divmod(self.tokens[stream].pop(), 32)
            must(code < 7, "CONN-9", "code 7")
            must(k == 31 if code == C else k < 31, "CONN-9", f"code {code} with k = {k}")
            self.run, self.last = k, code if code != C else None
        if self.run:
            self.run -= 1
            return C
        op, self.last = self.last, None
        return op

    def target(self, walk, gate):
        """[CONN-10]"""
        must(self.references, "CONN-10", "no reference left")
        reference = self.references.pop()
        if reference:
            return walk.near_item(gate, reference)
        must(self.far, "CONN-10", "no far target left")
        return self.far.pop()

    def end(self):
        """[CONN-2]"""
        used = not any(self.tokens) and not self.references and not self.far and not self.run and self.last is None
        must(used, "CONN-2", "tokens, references or far targets are left over")


def CONN_12_run_weights(full):
    def weight(s):
        distance = abs(s - max(5 - full, 0))
        if s < 7:
            return {0: 32, 1: 8, 2: 2}.get(distance, 1)
        return {7: 6, 8: 2}.get(s, 1)
    return [weight(s) for s in range(16)]


class CompactOps:
    """[CONN-12] Ops and references of the compact form."""

    def __init__(self, data, m):
        must(m <= 42400 * len(data), "CONN-12", "more faces than the bytes can give")
        self.coder = Coder(data)
        self.runs = {}
        self.run_weights, self.rare_weights = mixing_weights(2), mixing_weights(2)
        self.rare = [symbol_models((0, 8, 0, 8, 1, 6, 5) + (0,) * 9), symbol_models((8, 1, 1, 0, 1, 8, 1) + (0,) * 9)]
        self.reference = NumberModel()
        self.cs, self.then = 0, None  # ops C to come, and what comes after these: R, "rare" or a "run"
        self.before = 1  # y of step 2

    def op(self, walk, t, g, step):
        a, b = int(walk.closed[walk.next[g]]), int(walk.closed[walk.prev[g]])
        q = walk.next[g]
        after = walk.next[q]
        F, K, T, X = (walk.full[i] for i in (t, walk.prev[g], after, walk.next[after]))
        O = walk.full[g if step == 1 else q]
        l = {2: 1, 3: 2, 4: 3}.get(walk.loop_size(g, 5), 0)
        def m(x, k):
            return min(x, k) - 1
        if step == 1:
            self.before = 1
            if self.then is None:
                self.then = "run"
            if self.cs == 0 and self.then == "run":
                first = (0, ((((F - 1) * 4 + max(walk.filled, 5) - 5) * 4 + m(K, 3)) * 2 + a) * 4 + l)
                second = (1, ((((F - 1) * 4 + m(X, 4)) * 4 + m(T, 4)) * 2 + a) * 4 + m(O, 4))
                models = [self.runs.setdefault(i, SymbolModel(CONN_12_run_weights(F))) for i in (first, second)]
                s = self.coder.symbol(models, self.run_weights[4 * (F - 1) + l])
                self.cs, self.then = (s, R) if s < 7 else (s - 7, "rare") if s < 14 else (7, "run")
            if self.cs:
                self.cs -= 1
                return C
            then, self.then = self.then, None
            if then == R:
                return R
        y = 0 if step == 1 else self.before
        n = ((y * 2 + a) * 2 + b) * 4 + l
        first, second = (4 * n + clamp(F, 2, 5) - 2) * 4 + m(O, 4), (2 * n + m(K, 2)) * 4 + m(T, 4)
        rare = self.rare[step - 1]
        op = self.coder.symbol([rare[0, first], rare[1, second]], self.rare_weights[n])
        must(op <= N, "CONN-7", f"op {op}")
        if step == 2:
            self.before = 2 if op == C else 3
        return op

    def target(self, walk, gate):
        reference = self.reference.decode(self.coder)
        must(reference <= 255, "CONN-12", f"reference {reference}")
        return walk.near_item(gate, reference) if reference else self.coder.raw(bits(len(walk.origin)))

    def end(self):
        must(self.cs == 0 and self.then is None, "CONN-2", "ops are left over")


class Walk:
    """[CONN-3 to CONN-8] The state, and the traversal that ops of either form drive."""

    def __init__(self, m, ops):
        self.m, self.ops = m, ops
        self.faces, self.manifold = [], 0
        self.origin, self.prev, self.next, self.closed, self.full, self.alive = [], [], [], [], [], []
        self.queues = [[] for _ in range(9)]
        self.heads = [0] * 9
        self.filled = 6

    def new_item(self, origin, full=1):
        self.origin.append(origin)
        self.full.append(full)
        self.closed.append(False)
        self.alive.append(True)
        self.prev.append(-1)
        self.next.append(-1)
        return len(self.origin) - 1

    def link(self, *chain):
        for a, b in zip(chain, chain[1:]):
            self.next[a], self.prev[b] = b, a

    def push(self, item):
        self.queues[self.full[item]].append(item)

    def loop_size(self, item, most):
        size, i = 1, self.next[item]
        while i != item and size < most:
            size, i = size + 1, self.next[i]
        return size

    def near_item(self, gate, reference):
        """[CONN-10] The item that a reference above 0 names."""
        steps, way = (reference // 2, self.prev) if reference % 2 == 0 else (reference // 2 + 2, self.next)
        for _ in range(steps):
            gate = way[gate]
        return gate

    def run(self):
        while len(self.faces) < self.m:
            self.CONN_4_component()
        must(len(self.faces) == self.m, "CONN-2", f"{len(self.faces)} faces in place of {self.m}")
        self.ops.end()

    def CONN_4_component(self):
        self.first_item = len(self.origin)
        v = self.manifold
        self.manifold += 3
        self.faces.append((v, v + 1, v + 2))
        items = [self.new_item(v + k) for k in range(3)]
        self.link(*items, items[0])
        for item in items:
            self.push(item)
        while (t := self.CONN_5_gap()) is not None:
            self.CONN_6_fill(t)

    def CONN_5_gap(self):
        while number := next((k for k in range(8, 0, -1) if self.heads[k] < len(self.queues[k])), 0):
            t = self.queues[number][self.heads[number]]
            self.heads[number] += 1
            if self.alive[t] and not (self.closed[t] and self.closed[self.prev[t]]):
                return t
        return None

    def CONN_6_fill(self, t):
        while not self.closed[self.prev[t]]:
            full = self.full[t]
            op = self.ops.op(self, t, self.prev[t], 1)
            self.CONN_6_op(op, self.prev[t], 1)
            if op in (R, E):
                self.filled = min(full + 1, 8)
                return
        while not self.closed[t]:
            self.CONN_6_op(self.ops.op(self, t, t, 2), t, 2)
        self.filled = self.full[t]

    def grow(self, *items):
        for item in items:
            self.full[item] = min(self.full[item] + 1, 8)

    def CONN_6_op(self, op, g, step):
        p, q = self.prev[g], self.next[g]
        u, v = self.origin[g], self.origin[q]
        must(op == B or len(self.faces) < self.m, "CONN-2", "more faces than stated")
        u_pushes, v_pushes = ([g], []) if step == 1 else ([], [q])
        pushes = []
        if op == C:
            apex = self.manifold
            self.manifold += 1
            f = self.new_item(apex)
            self.link(g, f, q)
            self.grow(g, q)
            pushes = u_pushes + v_pushes
        elif op == L:
            apex = self.origin[p]
            must(not self.closed[p] and apex != v, "CONN-7", "L does not fit")
            self.alive[g] = False
            self.link(p, q)
            self.grow(q, p)
            pushes = [p]
        elif op == R:
            after = self.next[q]
            apex = self.origin[after]
            must(not self.closed[q] and apex != u, "CONN-7", "R does not fit")
            self.alive[q] = False
            self.link(g, after)
            self.grow(g, after)
            pushes = u_pushes + [after]
        elif op == E:
            apex = self.origin[p]
            fits = not self.closed[p] and not self.closed[q] and self.next[q] == p and len({p, g, q}) == 3
            must(fits, "CONN-7", "E does not fit")
            for item in (p, g, q):
                self.alive[item] = False
        elif op in (S, N):
            s = self.ops.target(self, g) if op == S else self.next[self.next[q]]
            made = self.first_item <= s < len(self.origin) and self.alive[s]
            must(made and self.origin[s] not in (u, v), "CONN-7", f"item {s} is no target")
            apex = self.origin[s]
            self.grow(g, q, s)
            f = self.new_item(apex, self.full[s])
            r = self.prev[s]
            self.link(g, s)
            self.link(r, f)
            self.link(f, q)
            pushes = u_pushes + [f, s] + v_pushes
        else:  # B
            self.closed[g] = True
            return
        self.faces.append((v, u, apex))
        for item in pushes:
            self.push(item)
