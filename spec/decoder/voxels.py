"""Voxel edges: posn.md, POSN-12 and VOX-1 to VOX-6."""
from coder import NumberModel, SymbolModel, clamp, symbol_models
from container import must, unzigzag
from graph import corners, others
from lattice import Context, Kept, Known, NumberCoder, POSN_4_expect, POSN_5_coded

def wrap16(x):
    return (x + 2**15) % 2**16 - 2**15

def divide(a, b):
    """The quotient cut towards 0."""
    return abs(a) // abs(b) * (1 if (a < 0) == (b < 0) else -1)

def edge_direction(number):
    """Where the middle of a cube's edge is from the cube's centre."""
    k, i = divmod(number, 4)
    d = [0, 0, 0]
    d[(k + 1) % 3], d[(k + 2) % 3] = 2 * (i % 2) - 1, 2 * (i // 2) - 1
    return tuple(d)

NUMBERS = {edge_direction(e): e for e in range(12)}

def VOX_turns():
    """For each of the 24 turns the number of every edge after it."""
    turns = []
    for index, p in enumerate(((0, 1, 2), (1, 2, 0), (2, 0, 1), (0, 2, 1), (2, 1, 0), (1, 0, 2))):
        for signs in range(8):
            if bin(signs).count("1") % 2 == (index >= 3):
                turned = [[(-1 if signs >> a & 1 else 1) * edge_direction(e)[p[a]] for a in range(3)] for e in range(12)]
                turns.append([NUMBERS[tuple(d)] for d in turned])
    return turns

TURNS = VOX_turns()

def cubes_of(axis, node):
    """The lowest nodes of the four cubes that an edge belongs to."""
    i, j = (axis + 1) % 3, (axis + 2) % 3
    result = []
    for di in (1, 0):
        for dj in (1, 0):
            cube = list(node)
            cube[i], cube[j] = cube[i] - di, cube[j] - dj
            result.append(tuple(cube))
    return result

def edge_number(axis, node):
    """The number of an edge of the cube at (0, 0, 0), or None."""
    i, j = node[(axis + 1) % 3], node[(axis + 2) % 3]
    return 4 * axis + i + 2 * j if node[axis] == 0 and i in (0, 1) and j in (0, 1) else None

def edge_of(number):
    """Axis and node of an edge of the cube at (0, 0, 0)."""
    d = edge_direction(number)
    return number // 4, tuple(int(x > 0) for x in d)

def POSN_12_known(faces, n, turn):
    at, result = corners(faces, n), [None] * n
    for v in sorted(range(n), key=lambda v: turn[v]):
        found = [others(faces, c) for c in at[v]]
        found = [(a, b) for a, b in found if turn[a] < turn[v] and turn[b] < turn[v] and a != b]
        kept = []
        for a, b in found[:1] + found[1:][-1:]:
            low, high = sorted((a, b), key=lambda u: turn[u])
            kept.append((a, b, next((y if x == low else x for x, y, _ in result[high].faces if low in (x, y)), None)))
        result[v] = Known(kept, len(at[v]))
    return result

class Cube:
    """[VOX-2, VOX-3] What is known of a vertex that has a cube."""
    def __init__(self, voxels, face, last, upper=False):
        a, b, o = face
        edges, spots = voxels.edges, voxels.spots
        (axis_a, node_a), (axis_b, node_b) = edges[a], edges[b]
        away = [wrap16(128 * (y - x)) >> 7 for x, y in zip(node_a, node_b)]
        theirs = cubes_of(axis_b, away)
        common = sorted(c for c in cubes_of(axis_a, (0, 0, 0)) if c in theirs)
        o = o if o in edges else None
        cube, other, self.open = common[-1 if upper else 0], None, False
        if len(common) == 2:
            axis = next(i for i in range(3) if common[0][i] != common[1][i])
            other = common[0 if upper else 1]
            plane = 128 * (node_a[axis] + common[1][axis])
            side = wrap16(spots[o][axis] - plane) if o is not None else 0
            if side:
                cube, other = (common[1], common[0]) if side < 0 else common
            else:
                self.open = not upper
        self.node = tuple(x + y for x, y in zip(node_a, cube))

        def number(u, where):  # of u's edge in the cube at `where`, which counts from a's node
            axis, node = edges[u]
            return edge_number(axis, [wrap16(128 * (y - x)) // 128 - w for x, y, w in zip(node_a, node, where)])
        e_a, e_b = number(a, cube), number(b, cube)
        self.turn = min((t for t in TURNS if t[e_a] == 0), key=lambda t: t[e_b])
        self.kind = (1, 3, 4, 5, 6, 7).index(self.turn[e_b])
        e_o = number(o, other or cube) if o is not None else None
        self.opposite = 13 if self.open else 12 if e_o is None else self.turn[e_o]
        self.VOX_3_target(voxels, face, o, last)
        self.VOX_3_likely(voxels, (e_a, e_b), last)

    def VOX_3_target(self, voxels, face, o, last):
        def spot(u, beyond):
            at = [wrap16(s - 128 * x) for s, x in zip(voxels.spots[u], self.node)]
            return [(clamp(x, -256, 384) if beyond else x) - 64 for x in at]
        self.A, self.B = spot(face[0], False), spot(face[1], False)
        ends = [self.A, self.B] + [spot(u, last[:2] != face[:2]) for u in last[:2]]
        self.M = [sum(x) >> 2 for x in zip(*ends)]
        target = self.M
        if o is not None:
            target = [m + ((5 * (a + b - x - m)) >> 3) for m, a, b, x in zip(self.M, self.A, self.B, spot(o, True))]
        self.X = [clamp(x, -127, 127) for x in target]

    def VOX_3_likely(self, voxels, own, last):
        first = [e for e in range(12) if e not in own]
        left = list(first)
        for u in last[:2]:
            axis, node = voxels.edges[u]
            node = tuple(clamp(wrap16(128 * (y - x)) >> 7, -2, 3) for x, y in zip(self.node, node))
            cubes = set(cubes_of(axis, node))
            near = [e for e in range(12) if edge_of(e) != (axis, node) and cubes & set(cubes_of(*edge_of(e)))]
            left = [e for e in left if e in near or not near]
        self.likely = frozenset(self.turn[e] for e in left or first)

    def VOX_4_model(self):
        """A key and the first weights of the edge symbol's model."""
        weights = [20 if e in self.likely else 1 for e in range(12)] + [1, 100 if self.opposite == 13 else 0, 0, 0]
        return (self.kind, self.likely, self.opposite), weights

class VoxelCoder:
    def __init__(self, coder, faces, n, header):
        self.coder, self.n, self.cells, self.levels, self.width = coder, n, header.cells, header.levels, 2 * header.levels
        self.half = (n + 1) // 2
        turn = [v if v < self.half else v - self.half for v in range(n)]
        self.known = POSN_12_known(faces, n, turn)
        self.table = [((45, 55, 50, 45)[row // 6], 0) for row in range(24)]
        self.rows, self.edges, self.spots, self.kept = {}, {}, {}, Kept()
        self.numbers, self.nodes, self.start = NumberCoder(), [NumberModel() for _ in range(3)], SymbolModel((8,) * 4 + (1,) * 12)
        self.edge_models = {}
        self.low = max((header.levels - 1).bit_length() - 4, 0)  # g
        self.level_models = symbol_models([int(h <= (header.levels - 1) >> self.low) for h in range(16)])

    def turn(self, i):
        """[POSN-12]"""
        vertices = [v for v in (i, i + self.half) if v < (self.half if v == i else self.n)]
        cubes = [self.VOX_2_cube(v) for v in vertices]
        symbols = [self.VOX_4_symbol(cube) if cube else (None, 12) for cube in cubes]
        for v, (cube, symbol) in zip(vertices, symbols):
            self.VOX_1_vertex(v, cube, symbol)

    def VOX_2_cube(self, v):
        """A function that makes the vertex' cube, the lower or the upper one; None where there is none."""
        def has_cube(face):
            a, b, _ = face
            if a not in self.edges or b not in self.edges or self.edges[a] == self.edges[b]:
                return False
            (axis_a, node_a), (axis_b, node_b) = self.edges[a], self.edges[b]
            away = [wrap16(128 * (y - x)) >> 7 for x, y in zip(node_a, node_b)]
            return max(map(abs, away)) <= 2 and bool(set(cubes_of(axis_a, (0, 0, 0))) & set(cubes_of(axis_b, away)))
        faces = self.known[v].faces
        face = next((f for f in faces if has_cube(f)), None)
        if face is None:
            return None
        last = faces[-1] if faces[-1][0] in self.edges and faces[-1][1] in self.edges else face
        return lambda upper: Cube(self, face, last, upper)

    def VOX_4_symbol(self, make):
        """The cube and the edge symbol."""
        cube = make(False)
        symbol = self.edge_symbol(cube)
        if symbol == 13 and cube.open:
            cube = make(True)
            symbol = self.edge_symbol(cube)
        must(symbol <= 12, "VOX-4", f"edge symbol {symbol}")
        return cube, symbol

    def edge_symbol(self, cube):
        key, weights = cube.VOX_4_model()
        return self.coder.symbol([self.edge_models.setdefault(key, SymbolModel(weights))])

    def VOX_1_vertex(self, v, cube, symbol):
        if symbol < 12:
            axis, at = edge_of(cube.turn.index(symbol))
            node, level = [x + y for x, y in zip(cube.node, at)], self.VOX_6_level(axis, at, cube)
        else:
            axis = self.coder.symbol([self.start])
            must(axis <= 3, "VOX-1", f"start symbol {axis}")
            if axis == 3:
                self.anywhere(v)
                return
            node = [self.VOX_5_node(v, a) for a in range(3)]
            level = self.VOX_6_level(axis, None, None)
        row = [x * self.width for x in node]
        row[axis] += 2 * level + 1
        must(all(0 <= q <= most for q, most in zip(row, self.cells)), "POSN-7", f"coordinates {row}")
        spot = [128 * x for x in node]
        spot[axis] += ((2 * level + 1) * (2**32 // self.levels)) // 2**26
        self.rows[v], self.edges[v], self.spots[v] = row, (axis, tuple(node)), spot

    def expect(self, v, axis):
        before = self.rows[v - 1][axis] if v not in (0, self.half) else 0
        return POSN_4_expect(self.known[v], self.table, self.rows.__getitem__, axis, before)

    def VOX_5_node(self, v, axis):
        most = self.cells[axis] // self.width
        expected = clamp(divide(self.expect(v, axis)[0] >> 4, self.width), 0, most)
        node = expected + unzigzag(self.nodes[axis].decode(self.coder))
        must(0 <= node <= most, "VOX-5", f"node {node}")
        return node

    def VOX_6_level(self, k, at, cube):
        if self.levels == 1:
            return 0
        t = p = 0
        if cube:
            t, E, F = cube.M[k], [b - a for a, b in zip(cube.A, cube.B)], [x - a for a, x in zip(cube.A, cube.X)]
            N = [((E[(i + 1) % 3] * F[(i + 2) % 3]) >> 1) - ((E[(i + 2) % 3] * F[(i + 1) % 3]) >> 1) for i in range(3)]
            d = [0 if i == k else 64 if at[i] else -64 for i in range(3)]
            above = sum(x * y for x, y in zip(N, d)) - sum(x * y for x, y in zip(N, cube.A))
            p = divide(-above, N[k] or 1)
        h = self.coder.symbol([self.level_models[20 * clamp((t + 80) >> 3, 0, 19) + clamp((p + 80) >> 3, 0, 19)]])
        low = self.coder.raw(self.low) if self.low else 0
        return min(h << self.low | low, self.levels - 1)

    def anywhere(self, v):
        """[VOX-1] Start symbol 3."""
        known = self.known[v]
        left = [(a if a not in self.edges else b, b if b not in self.edges else a, o) for a, b, o in known.faces
                if a not in self.edges or b not in self.edges]
        G, R = self.kept.sums(left)
        c = len(known.parallelograms)
        sources = min(c, 3) + 1 if c else int(bool(left))
        row, off, places = [], [], []
        for a in range(3):
            place, spread = self.expect(v, a)
            whole = clamp((place + 8) >> 4, 0, self.cells[a])
            q = whole + self.numbers.decode(self.coder, Context(a, place, spread, G, R[a], sources, POSN_5_coded(a, off), whole))
            must(0 <= q <= self.cells[a], "POSN-7", f"coordinate {q} of vertex {v}")
            row.append(q)
            off.append(q - whole)
            places.append(place)
        self.rows[v] = row
        self.kept.keep(v, row, places, sources, G)

def VOX_1_rows(coder, faces, n, header):
    """The lattice coordinates of all vertices, in the walk's order."""
    voxels = VoxelCoder(coder, faces, n, header)
    for i in range(voxels.half):
        voxels.turn(i)
    return [voxels.rows[v] for v in range(n)]
