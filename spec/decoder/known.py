"""What a part with voxel edges knows of its base: map.md, MAP-26 to MAP-30. Nodes, cubes and edges are those of cubes.py."""
import math
from collections import defaultdict
from itertools import product

from coder import CountedBit, Fresh, clamp
from container import must
from cubes import brick_of, corner_of, edge_of, moved

class NothingKnown:  # MAP-26
    """A mesh that is not beside a base."""
    cubes, states, levels, count = {}, {}, {}, 0

class Known:
    """[MAP-26, MAP-27] Of the base, on the grid of the part: `levels` of edges; former `cubes` with the faces in them; former `states` of nodes."""
    def __init__(self, mesh, header):
        self.cubes, self.states, self.levels, self.rows = {}, {}, {}, {}
        self.count, self.header, self.attributes = len(mesh.positions), header, mesh.attributes
        self.homes = [self.MAP_26_home(position, header) for position in mesh.of_stream.tolist()]
        for v, (edge, level) in enumerate(self.homes):
            if edge and edge not in self.levels:
                self.levels[edge], self.rows[edge] = level, v
        for face in mesh.faces:
            self.MAP_27_face([self.homes[v][0] for v in face])
        around = [tuple(c + d for c, d in zip(cube, by)) for cube in self.cubes for by in product((-1, 0, 1), repeat=3)]
        bricks = {brick_of(node) for node in [r for _, r in self.levels] + around}
        must(len(bricks) <= min(64 + self.count // 16, 2**20 - 64), "MAP-27", "too many bricks of the base")
        for cube in self.cubes:
            for k, a in [edge_of(cube, number) for number in range(12)] * 8:
                b = moved(a, k, 1)
                if (k, a) not in self.levels and (a in self.states) != (b in self.states):
                    self.states[a] = self.states[b] = self.states.get(a, self.states.get(b))

    def MAP_26_home(self, position, header):
        """Edge and level of a vertex, or nothing."""
        w = 2 * header.levels
        u = [(x - o) / s - f for x, o, s, f in zip(position, header.lattice_origin, header.steps, header.first)]
        if not all(-0.5 <= x <= cells + 0.5 for x, cells in zip(u, header.cells)):
            return None, 0
        node = [math.floor(x / w + 0.5) for x in u]
        off = [abs(x - w * r) for x, r in zip(u, node)]
        k = off.index(max(off))
        if any(off[a] > w / 8 for a in range(3) if a != k):
            return None, 0
        node[k] = math.floor(max(u[k], 0) / w)
        return (k, tuple(node)), clamp(math.floor((u[k] - w * node[k]) / 2), 0, header.levels - 1)

    def MAP_30_former(self, number, positions, level_bits):
        """By vertex: the levels of attribute `number` that the base's vertex on its edge has."""
        former, a = {}, self.attributes[number]
        for v, position in enumerate(positions.tolist()):
            edge = self.MAP_26_home(position, self.header)[0]
            if edge in self.rows:
                former[v] = [MAP_30_level(x, a.type, level_bits) for x in a.values[self.rows[edge]]]
        return former

    def MAP_27_face(self, edges):
        if None in edges or len(set(edges)) < 3:
            return
        cube = tuple(max(r[a] - (a != k) for k, r in edges) for a in range(3))
        if any(r[a] < cube[a] for _, r in edges for a in range(3)):
            return
        numbers = [4 * k + r[(k + 1) % 3] - cube[(k + 1) % 3] + 2 * (r[(k + 2) % 3] - cube[(k + 2) % 3]) for k, r in edges]
        triangle = min((tuple(numbers[i:] + numbers[:i]) for i in range(3)), key=lambda turn: turn[0])
        self.cubes.setdefault(cube, []).append(triangle)
        a, b, c = ([2 * x + (axis == k) for axis, x in enumerate(r)] for k, r in edges)
        for k, r in edges:
            i, j = (k + 1) % 3, (k + 2) % 3
            n = (b[i] - a[i]) * (c[j] - a[j]) - (b[j] - a[j]) * (c[i] - a[i])
            if n:
                inside, outside = (r, moved(r, k, 1)) if n > 0 else (moved(r, k, 1), r)
                self.states.setdefault(inside, 0)
                self.states.setdefault(outside, 1)

def MAP_30_level(x, kind, level_bits):
    if kind == "f4":
        return math.floor((2**level_bits - 1) * float(x) + 0.5) if 0 <= x <= 1 else 0
    return (int(x) + 128) // 257 if kind == "u2" and level_bits == 8 else int(x)

def MAP_28_wrong(known, nodes, own):
    return min(sum(node in nodes and nodes[node] != known.states.get(node, nodes[node]) for node in own), 3)

def likely(is_likely):  # MAP-28
    return CountedBit(61000 if is_likely else 4535)

def MAP_28_fresh_flag(number):
    return likely(number // 12 & 1)

def MAP_28_fresh_sign(number):
    return likely(number & 1)

def MAP_28_fresh_pattern(number):
    return likely(not number)

def MAP_28_fresh_beside(number):
    return CountedBit((49152, 24576, 8192, 4096)[number & 3] if number // 12 else 4535)

def MAP_28_flag(known, nodes, own, F):
    """The model of a former cube; `own`: its corners."""
    now = [nodes[node] for node in own if node in nodes]
    mixed, count = len(set(now)) == 2, 2 if len(now) == 8 else min(len(now), 1)
    return ((2 * MAP_28_wrong(known, nodes, own) + mixed) * 3 + count) * 4 + min(F, 3)

def MAP_28_beside(known, nodes, own, F):
    """The model of another cube, of whose known corners some were inside and some outside; or None."""
    count = sum(node in nodes for node in own)
    if len({known.states[node] for node in own if node in nodes and node in known.states}) < 2:
        return None
    return 4 * (3 * MAP_28_wrong(known, nodes, own) + (count == 8) + (count >= 5)) + min(F, 3)

def MAP_28_sign(known, nodes, own, j, M):
    """The model of a corner with a former state."""
    beside = [nodes[own[j ^ t]] for t in (1, 2, 4) if own[j ^ t] in nodes]
    index = (3 * MAP_28_wrong(known, nodes, own) + M) * 16 + 4 * sum(beside) + len(beside) - sum(beside)
    return 2 * index + known.states[own[j]]

def MAP_28_pattern(known, nodes, own):
    """The model of whether the pattern is that of the base's faces, or None."""
    if own[0] in known.cubes and all(node in known.states for node in own):
        return int(MAP_28_wrong(known, nodes, own) > 0)
    return None

def MAP_29_motion(cuts, former, k, r, is_outside, symbols):
    """Of the twelve cuts around: how many are still, 2 at most; the class of how many have moved, and how far; the way of the four beside."""
    def ways(places):
        return [cuts[at] - former[at] for at in places if at in cuts and at in former]
    beside, across = [], []
    for axis in {0, 1, 2} - {k}:
        beside += [(k, moved(r, axis, by)) for by in (1, -1)]
        across += [(axis, moved(end, axis, by)) for end in (r, moved(r, k, 1)) for by in (0, -1)]
    of_beside = ways(beside)
    of_all = of_beside + ways(across)
    count = sum(way != 0 for way in of_all)
    far = 2 * symbols * sum(map(abs, of_all)) >= 192 * count
    way = sum(of_beside) * (-1 if is_outside else 1)
    return min(len(of_all) - count, 2), 1 + far + 2 * (count > 1) if count else 0, 1 + (way > 0) - (way < 0)

class FormerLevels:
    """[MAP-29] Levels of vertices that have former ones; symbols are levels without the lowest g bits."""
    def __init__(self, known, levels, g):
        self.known, self.levels, self.g, self.symbols = known, levels, g, ((levels - 1) >> g) + 1
        self.cuts = {edge: 32 * (2 * level + 1) // levels - 32 for edge, level in known.levels.items()}
        self.is_same = Fresh(lambda i: CountedBit(5 + i % 3 - i // 3 << 13))
        self.is_above = Fresh(lambda i: CountedBit(1 + i % 3 + i // 3 << 13))
        self.is_farther, self.is_former = defaultdict(CountedBit), defaultdict(CountedBit)

    def left(self, expected, s):
        return ((expected - 32 * (2 * s + 1) // self.symbols + 32) * self.symbols + 32) >> 6

    def symbol(self, coder, t, expected, i, moved_class, way):
        """The one that t leads to."""
        if self.is_same[i].decode(coder):
            return t
        step = 1 if t == 0 else -1
        if 0 < t < self.symbols - 1:
            step = 2 * self.is_above[3 * (clamp(self.left(expected, t), -2, 2) + 2) + way].decode(coder) - 1
        s, later = t + step, 0
        while 0 < s < self.symbols - 1:
            ahead = clamp(step * self.left(expected, s), -2, 2) + 2
            if not self.is_farther[2 * (3 * ahead + (moved_class and 2 - moved_class % 2)) + later].decode(coder):
                break
            s, later = s + step, 1
        return s

    def decode(self, coder, edge, is_outside, cuts, second):
        """The symbol for an edge that may begin outside, and its level if that is the former one, else None; `second` as in GRD-10."""
        c, line = second // 24, 8 * (second % 6) - 20
        f = self.levels - 1 - self.known.levels[edge] if is_outside else self.known.levels[edge]
        still, moved_class, way = MAP_29_motion(cuts, self.cuts, *edge, is_outside, self.symbols)
        i = 3 * moved_class + still
        symbol = self.symbol(coder, f >> self.g, (4 * c - 42 + line) // 2 if c else line, i, moved_class, way)
        return symbol, f if self.g and symbol == f >> self.g and self.is_former[i].decode(coder) else None
