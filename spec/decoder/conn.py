"""CONN: the faces over manifold vertices: conn.md."""
from collections import deque

from coder import Coder, NumberModel, SymbolModel, bits, clamp, mixing_weights, symbol_models
from container import Reader, must

C, L, R, E, S, B, N = range(7)

class PlainOps:
    """[CONN-1, CONN-2, CONN-9, CONN-10] Ops and references of the plain form."""
    def __init__(self, data, m, states):
        self.reader = r = Reader(data)
        counts = [r.varint() for _ in range(17)]
        references = r.varint()
        far, self.glued = r.varint(references), r.varint()
        self.tokens = [list(r.bytes(count))[::-1] for count in counts]
        self.references, self.far = list(r.bytes(references))[::-1], r.planes(far)[::-1]
        must(m <= 32 * sum(counts), "CONN-2", "more faces than tokens can give")
        self.ops = []  # of the last token, the next one last

    def op(self, walk, t, gate, step):
        """[CONN-9]"""
        if not self.ops:
            full, closed = walk.full[t], walk.closed[t]
            if step == 1 and walk.loop_size(gate) == 3 and full > 1 and not closed:
                stream = 16
            else:
                stream = min(full, 7) + (8 if step == 2 or closed else 0)
            must(self.tokens[stream], "CONN-9", f"stream {stream} has no token left")
            code, k = divmod(self.tokens[stream].pop(), 32)
            must(code < 7 and (k == 31) == (code == C), "CONN-9", f"code {code} with k = {k}")
            self.ops = ([code] if code else []) + [C] * k
        return self.ops.pop()

    def target(self, walk, gate):
        """[CONN-10]"""
        must(self.references, "CONN-10", "no reference left")
        reference = self.references.pop()
        must(reference or self.far, "CONN-10", "no far target left")
        return walk.CONN_10_near(gate, reference) if reference else self.far.pop()

    def CONN_2_end(self):
        left = any(self.tokens) or self.references or self.far
        must(not left, "CONN-2", "tokens, references or far targets are left over")

def CONN_12_run_weights(full):
    return [{0: 32, 1: 8, 2: 2}.get(abs(s - max(5 - full, 0)), 1) for s in range(7)] + [6, 2] + [1] * 7

class CompactOps:
    """[CONN-12] Ops and references of the compact form."""
    def __init__(self, data, m, states):
        must(m <= 42400 * len(data), "CONN-2", "more faces than the bytes can give")
        rare = [symbol_models((0, 8, 0, 8, 1, 6, 5) + (0,) * 9), symbol_models((8, 1, 1, 0, 1, 8, 1) + (0,) * 9)]
        self.learnt = states.models("ops", reference=NumberModel(), runs={}, run_weights=mixing_weights(), rare=rare,
                                    rare_weights=mixing_weights())
        self.coder = Coder(data)
        self.ops, self.y = [], 1  # "rare" and "run" among the ops stand for what is read when it is their turn

    def op(self, walk, t, g, step):
        p, q = walk.prev[g], walk.next[g]
        after = walk.next[q]
        a, b, l = walk.closed[q], walk.closed[p], {2: 1, 3: 2, 4: 3}.get(walk.loop_size(g), 0)
        F, O, K, T, X = (walk.full[i] for i in (t, g if step == 1 else q, p, after, walk.next[after]))
        def m(x, k):
            return min(x, k) - 1
        if step == 1:
            self.y, self.ops = 1, self.ops or ["run"]
            if self.ops == ["run"]:
                first = 0, ((((F - 1) * 4 + max(walk.filled, 5) - 5) * 4 + m(K, 3)) * 2 + a) * 4 + l
                second = 1, ((((F - 1) * 4 + m(X, 4)) * 4 + m(T, 4)) * 2 + a) * 4 + m(O, 4)
                models = [self.learnt.runs.setdefault(i, SymbolModel(CONN_12_run_weights(F))) for i in (first, second)]
                s = self.coder.symbol(models, self.learnt.run_weights[4 * (F - 1) + l])
                self.ops = [R] + [C] * s if s < 7 else ["rare"] + [C] * (s - 7) if s < 14 else ["run"] + [C] * 7
            op = self.ops.pop()
            if op != "rare":
                return op
        n = (((0 if step == 1 else self.y) * 2 + a) * 2 + b) * 4 + l
        first, second = (4 * n + clamp(F, 2, 5) - 2) * 4 + m(O, 4), (2 * n + m(K, 2)) * 4 + m(T, 4)
        rare = self.learnt.rare[step - 1]
        op = self.coder.symbol([rare[0, first], rare[1, second]], self.learnt.rare_weights[n])
        must(op <= N, "CONN-7", f"op {op}")
        self.y = 1 if step == 1 else 2 if op == C else 3
        return op

    def target(self, walk, gate):
        reference = self.learnt.reference.decode(self.coder)
        must(reference <= 255, "CONN-7", f"reference {reference}")
        return walk.CONN_10_near(gate, reference) if reference else self.coder.raw(bits(len(walk.origin)))

class Walk:
    """[CONN-3 to CONN-8] The state, and the traversal that ops of either form drive."""
    def __init__(self, m, ops):
        self.m, self.ops, self.faces, self.manifold, self.filled = m, ops, [], 0, 6
        self.origin, self.prev, self.next, self.closed, self.full, self.alive = [], [], [], [], [], []
        self.queues = [deque() for _ in range(9)]
        while len(self.faces) < m:
            self.CONN_4_component()

    def new_item(self, origin, full=1):
        for of, value in ((self.origin, origin), (self.full, full), (self.closed, False), (self.alive, True),
                          (self.prev, -1), (self.next, -1)):
            of.append(value)
        return len(self.origin) - 1

    def link(self, *chain):
        for a, b in zip(chain, chain[1:]):
            self.next[a], self.prev[b] = b, a

    def push(self, *items):
        for item in items:
            self.queues[self.full[item]].append(item)

    def grow(self, *items):
        for item in items:
            self.full[item] = min(self.full[item] + 1, 8)

    def loop_size(self, item):
        """Up to 5."""
        size, i = 1, self.next[item]
        while i != item and size < 5:
            size, i = size + 1, self.next[i]
        return size

    def CONN_10_near(self, gate, reference):
        """The item that a reference above 0 names."""
        steps, way = (reference // 2 + 2, self.next) if reference % 2 else (reference // 2, self.prev)
        for _ in range(steps):
            gate = way[gate]
        return gate

    def CONN_4_component(self):
        self.first_item, v = len(self.origin), self.manifold
        self.manifold += 3
        self.faces.append((v, v + 1, v + 2))
        items = [self.new_item(v + k) for k in range(3)]
        self.link(*items, items[0])
        self.push(*items)
        while (t := self.CONN_5_gap()) is not None:
            self.CONN_6_fill(t)

    def CONN_5_gap(self):
        while queue := next((queue for queue in reversed(self.queues) if queue), None):
            t = queue.popleft()
            if self.alive[t] and not (self.closed[t] and self.closed[self.prev[t]]):
                return t
        return None

    def CONN_6_fill(self, t):
        while not self.closed[self.prev[t]]:
            gate, full = self.prev[t], self.full[t]
            op = self.ops.op(self, t, gate, 1)
            self.CONN_6_op(op, gate, 1)
            if op in (R, E):
                self.filled = min(full + 1, 8)
                return
        while not self.closed[t]:
            self.CONN_6_op(self.ops.op(self, t, t, 2), t, 2)
        self.filled = self.full[t]

    def CONN_6_op(self, op, g, step):
        if op == B:
            self.closed[g] = True
            return
        must(len(self.faces) < self.m, "CONN-2", "more faces than stated")
        p, q, f = self.prev[g], self.next[g], len(self.origin)
        after, u, v = self.next[q], self.origin[g], self.origin[q]
        u_push, v_push = ([g], []) if step == 1 else ([], [q])
        if op == C:
            apex, self.manifold = self.manifold, self.manifold + 1
            self.new_item(apex)
            self.link(g, f, q)
            self.grow(g, q)
            pushes = u_push + v_push
        elif op == L:
            apex, pushes = self.origin[p], [p]
            must(not self.closed[p] and apex != v, "CONN-7", "L does not fit")
            self.alive[g] = False
            self.link(p, q)
            self.grow(q, p)
        elif op == R:
            apex, pushes = self.origin[after], u_push + [after]
            must(not self.closed[q] and apex != u, "CONN-7", "R does not fit")
            self.alive[q] = False
            self.link(g, after)
            self.grow(g, after)
        elif op == E:
            apex, pushes = self.origin[p], []
            must(not self.closed[p] and not self.closed[q] and after == p and len({p, g, q}) == 3, "CONN-7", "E does not fit")
            for item in (p, g, q):
                self.alive[item] = False
        else:
            s = self.ops.target(self, g) if op == S else self.next[after]
            must(self.first_item <= s < len(self.origin) and self.alive[s], "CONN-7", f"there is no item {s}")
            apex, r, pushes = self.origin[s], self.prev[s], u_push + [f, s] + v_push
            must(apex not in (u, v), "CONN-7", f"item {s} is no target")
            self.grow(g, q, s)
            self.new_item(apex, self.full[s])
            self.link(g, s)
            self.link(r, f)
            self.link(f, q)
        self.faces.append((v, u, apex))
        self.push(*pushes)
