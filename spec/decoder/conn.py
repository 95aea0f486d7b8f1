"""CONN: the faces over manifold vertices: conn.md."""
from collections import deque

from coder import Coder, Mixture, NumberModel, bits, clamp
from container import must

C, L, R, E, S, B, N = range(7)

def CONN_12_run_weights(full):
    return [{0: 32, 1: 8, 2: 2}.get(abs(s - max(5 - full, 0)), 1) for s in range(7)] + [6, 2] + [1] * 7

class Ops:
    """[CONN-1, CONN-10, CONN-12] Ops and references."""
    def __init__(self, r, m, states):
        must(m <= 42400 * len(r.data), "CONN-2", "more faces than the bytes can give")
        rare = [Mixture((0, 8, 0, 8, 1, 6, 5) + (0,) * 9), Mixture((8, 1, 1, 0, 1, 8, 1) + (0,) * 9)]
        runs = [Mixture(CONN_12_run_weights(full)) for full in range(9)]
        self.coder, self.learnt = Coder(r), states.models("ops", reference=NumberModel(), runs=runs, rare=rare)
        self.ops, self.y = [], 1  # "rare" and "run" among the ops stand for what is read when it is their turn

    def op(self, t, g, step, filled):
        """[CONN-12]"""
        p, q = g.prev, g.next
        after, a, b, l = q.next, q.closed, p.closed, {2: 1, 3: 2, 4: 3}.get(g.loop_size(), 0)
        F, O, K, T, X = (item.full for item in (t, g if step == 1 else q, p, after, after.next))
        def m(x, k):
            return min(x, k) - 1
        if step == 1:
            self.y, self.ops = 1, self.ops or ["run"]
            if self.ops == ["run"]:
                first = ((((F - 1) * 4 + max(filled, 5) - 5) * 4 + m(K, 3)) * 2 + a) * 4 + l
                second = ((((F - 1) * 4 + m(X, 4)) * 4 + m(T, 4)) * 2 + a) * 4 + m(O, 4)
                s = self.coder.symbol(*self.learnt.runs[F].of(first, second, 4 * (F - 1) + l))
                self.ops = [R] + [C] * s if s < 7 else ["rare"] + [C] * (s - 7) if s < 14 else ["run"] + [C] * 7
            op = self.ops.pop()
            if op != "rare":
                return op
        n = (((0 if step == 1 else self.y) * 2 + a) * 2 + b) * 4 + l
        first, second = (4 * n + clamp(F, 2, 5) - 2) * 4 + m(O, 4), (2 * n + m(K, 2)) * 4 + m(T, 4)
        op = self.coder.symbol(*self.learnt.rare[step - 1].of(first, second, n))
        must(op <= N, "CONN-7", f"op {op}")
        self.y = 1 if step == 1 else 2 if op == C else 3
        return op

    def target(self, items):
        """[CONN-10]"""
        reference = self.learnt.reference.decode(self.coder)
        must(reference <= 255, "CONN-7", f"reference {reference}")
        return reference, None if reference else self.coder.raw(bits(items))

class Item:
    """[CONN-3]"""
    def __init__(self, origin, full=1):
        self.origin, self.full, self.closed, self.alive = origin, full, False, True

    def loop_size(self):
        """Up to 5."""
        size, item = 1, self.next
        while item is not self and size < 5:
            size, item = size + 1, item.next
        return size

def link(*chain):  # CONN-6
    for a, b in zip(chain, chain[1:]):
        a.next, b.prev = b, a

def grow(*items):  # CONN-6
    for item in items:
        item.full = min(item.full + 1, 8)

class Traversal:
    """[CONN-3 to CONN-8] The state, and the traversal that ops drive."""
    def __init__(self, m, ops):
        self.m, self.ops, self.faces, self.manifold, self.filled, self.items = m, ops, [], 0, 6, []
        self.queues = [deque() for _ in range(9)]
        while len(self.faces) < m:
            self.CONN_4_component()

    def new_item(self, origin, full=1):  # CONN-3
        self.items.append(Item(origin, full))
        return self.items[-1]

    def push(self, *items):  # CONN-3
        for item in items:
            self.queues[item.full].append(item)

    def CONN_4_component(self):
        self.first_item, v = len(self.items), self.manifold
        self.manifold += 3
        self.faces.append((v, v + 1, v + 2))
        items = [self.new_item(v + k) for k in range(3)]
        link(*items, items[0])
        self.push(*items)
        while t := self.CONN_5_gap():
            self.CONN_6_fill(t)

    def CONN_5_gap(self):
        while queue := next((queue for queue in reversed(self.queues) if queue), None):
            t = queue.popleft()
            if t.alive and not (t.closed and t.prev.closed):
                return t
        return None

    def CONN_6_fill(self, t):
        while not t.prev.closed:
            full, op = t.full, self.ops.op(t, t.prev, 1, self.filled)
            self.CONN_6_op(op, t.prev, 1)
            if op in (R, E):
                self.filled = min(full + 1, 8)
                return
        while not t.closed:
            self.CONN_6_op(self.ops.op(t, t, 2, self.filled), t, 2)
        self.filled = t.full

    def CONN_10_target(self, gate):
        reference, number = self.ops.target(len(self.items))
        if reference == 0:
            must(self.first_item <= number < len(self.items), "CONN-7", f"there is no item {number}")
            return self.items[number]
        for _ in range(reference // 2 + 2 * (reference % 2)):
            gate = gate.next if reference % 2 else gate.prev
        return gate

    def CONN_6_op(self, op, g, step):
        if op == B:
            g.closed = True
            return
        must(len(self.faces) < self.m, "CONN-2", "more faces than stated")
        p, q, after = g.prev, g.next, g.next.next
        u, v, u_push, v_push = g.origin, q.origin, [g] if step == 1 else [], [q] if step == 2 else []
        if op == C:
            apex, self.manifold, pushes = self.manifold, self.manifold + 1, u_push + v_push
            link(g, self.new_item(apex), q)
            grow(g, q)
        elif op == L:
            apex, pushes = p.origin, [p]
            must(not p.closed, "CONN-7", "L beside a closed item")
            must(apex != v, "CONN-7", "L in a loop of two")
            g.alive = False
            link(p, q)
            grow(q, p)
        elif op == R:
            apex, pushes = after.origin, u_push + [after]
            must(not q.closed, "CONN-7", "R beside a closed item")
            must(apex != u, "CONN-7", "R in a loop of two")
            q.alive = False
            link(g, after)
            grow(g, after)
        elif op == E:
            apex, pushes = p.origin, []
            must(not p.closed, "CONN-7", "E after a closed item")
            must(not q.closed, "CONN-7", "E before a closed item")
            must(after is p, "CONN-7", "E in no loop of three")
            p.alive = g.alive = q.alive = False
        else:
            s = self.CONN_10_target(g) if op == S else after.next
            apex, r = s.origin, s.prev
            must(s.alive, "CONN-7", "the target was removed")
            must(apex not in (u, v), "CONN-7", "the target begins at an end of the gate")
            grow(g, q, s)
            f = self.new_item(apex, s.full)
            pushes = u_push + [f, s] + v_push
            link(g, s)
            link(r, f, q)
        self.faces.append((v, u, apex))
        self.push(*pushes)
