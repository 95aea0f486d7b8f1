"""Voxel edges: posn.md, POSN-12 and VOX-1 to VOX-6."""
from coder import NumberModel, SymbolModel, clamp, symbol_models
from container import must, unzigzag
from graph import corners, others
from lattice import Context, Kept, Known, NumberCoder, POSN_4_expect, POSN_5_coded

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

def VOX_rotations():
    """For each of the 24 rotations the number of every edge after it."""
    rotations = []
    for index, p in enumerate(((0, 1, 2), (1, 2, 0), (2, 0, 1), (0, 2, 1), (2, 1, 0), (1, 0, 2))):
        for signs in range(8):
            if bin(signs).count("1") % 2 == (index >= 3):
                rotated = [[(-1 if signs >> a & 1 else 1) * edge_direction(e)[p[a]] for a in range(3)] for e in range(12)]
                rotations.append([NUMBERS[tuple(d)] for d in rotated])
    return rotations

ROTATIONS = VOX_rotations()

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

def POSN_12_known(faces, n, step):
    at, result = corners(faces, n), [None] * n
    for v in sorted(range(n), key=lambda v: step[v]):
        found = [others(faces, c) for c in at[v]]
        found = [(a, b) for a, b in found if step[a] < step[v] and step[b] < step[v] and a != b]
        kept = []
        for a, b in dict.fromkeys(found[:1] + found[-1:]):
            low, high = sorted((a, b), key=lambda u: step[u])
            kept.append((a, b, next((y if x == low else x for x, y, _ in result[high].faces if low in (x, y)), None)))
        result[v] = Known(kept, len(kept))
    return result

def near(x, y):
    """[VOX-2] Of two edges."""
    return max(abs(i - j) for i, j in zip(x[1], y[1])) <= 2

def shared(x, y):
    """The cubes that have both edges, the lower one first."""
    return sorted(set(cubes_of(*x)) & set(cubes_of(*y)))

class Cube:
    """[VOX-2, VOX-3] What is known of a vertex that has a cube."""
    def __init__(self, voxels, corners, upper=False):
        a, b, c, d, o = corners
        edge = voxels.edges
        common = shared(edge[a], edge[b])
        cube, other, self.open = common[0], common[-1], False
        if len(common) == 2:
            axis = next(i for i in range(3) if common[0][i] != common[1][i])
            side = voxels.spots[o][axis] - 128 * common[1][axis] if o is not None else 0
            self.open = side == 0 and not upper
            if side < 0 or upper:
                cube, other = other, cube
        self.node = cube

        def number(u, where):  # of u's edge in the cube at `where`
            axis, node = edge[u]
            return edge_number(axis, [x - y for x, y in zip(node, where)])
        e_a, e_b = number(a, cube), number(b, cube)
        self.rotation = min((t for t in ROTATIONS if t[e_a] == 0), key=lambda t: t[e_b])
        self.kind = (1, 3, 4, 5, 6, 7).index(self.rotation[e_b])
        e_o = number(o, other) if o is not None else None
        self.opposite = 13 if self.open else 12 if e_o is None else self.rotation[e_o]
        self.VOX_3_target(voxels, corners)
        self.VOX_3_likely(edge, corners[:4])

    def VOX_3_target(self, voxels, corners):
        spots = [u if u is None else [s - 128 * x - 64 for s, x in zip(voxels.spots[u], self.node)] for u in corners]
        self.A, self.B, O = spots[0], spots[1], spots[4]
        self.M = self.X = [sum(x) >> 2 for x in zip(*spots[:4])]
        if O is not None:
            self.X = [m + ((5 * (a + b - x - m)) >> 3) for m, a, b, x in zip(self.M, self.A, self.B, O)]

    def VOX_3_likely(self, edge, corners):
        def at(e):
            axis, node = edge_of(e)
            return axis, tuple(x + y for x, y in zip(node, self.node))
        own = [edge[u] for u in corners]
        likely = [e for e in range(12) if at(e) not in own and shared(at(e), own[2]) and shared(at(e), own[3])]
        self.likely = frozenset(self.rotation[e] for e in likely)

    def VOX_4_model(self):
        """A key and the first weights of the edge symbol's model."""
        weights = [20 if e in self.likely else 1 for e in range(12)] + [1, 100 if self.opposite == 13 else 0, 0, 0]
        return (self.kind, self.likely, self.opposite), weights

class VoxelCoder:
    def __init__(self, coder, faces, n, header):
        self.coder, self.n, self.cells, self.levels, self.width = coder, n, header.cells, header.levels, 2 * header.levels
        self.half = (n + 1) // 2
        step = [v if v < self.half else v - self.half for v in range(n)]
        self.known = POSN_12_known(faces, n, step)
        self.table = [((45, 55, 50, 45)[row // 6], 0) for row in range(24)]
        self.rows, self.edges, self.spots, self.kept = {}, {}, {}, Kept()
        self.numbers, self.nodes, self.start = NumberCoder(), [NumberModel() for _ in range(3)], SymbolModel((8,) * 4 + (1,) * 12)
        self.edge_models = {}
        self.low = max((header.levels - 1).bit_length() - 4, 0)  # g
        self.level_models = symbol_models([int(h <= (header.levels - 1) >> self.low) for h in range(16)])

    def step(self, i):
        """[POSN-12, VOX-1]"""
        for v in (i, i + self.half):
            if v < (self.half if v == i else self.n):
                cube = self.VOX_2_cube(v)
                self.VOX_1_vertex(v, *(self.VOX_4_symbol(cube) if cube else (None, 12)))

    def VOX_2_cube(self, v):
        """A function that makes the vertex' cube, the lower or the upper one; None where there is none."""
        faces, edge = self.known[v].faces, self.edges
        if not faces:
            return None
        (a, b, o), (c, d, _) = faces[0], faces[-1]
        if a not in edge or b not in edge or edge[a] == edge[b] or not shared(edge[a], edge[b]):
            return None
        if not all(u in edge and near(edge[u], edge[a]) for u in (c, d)):
            c, d = a, b
        if o not in edge or not near(edge[o], edge[a]):
            o = None
        return lambda upper: Cube(self, (a, b, c, d, o), upper)

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
            axis, at = edge_of(cube.rotation.index(symbol))
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
        spot[axis] += 64 * (2 * level + 1) // self.levels
        self.rows[v], self.edges[v], self.spots[v] = row, (axis, tuple(node)), spot
        self.kept.keep_nothing(v)

    def expect(self, v, axis):
        before = self.rows[v - 1][axis] if v not in (0, self.half) else 0
        return POSN_4_expect(self.known[v], self.table, self.rows.__getitem__, axis, before)

    def VOX_5_node(self, v, axis):
        most = self.cells[axis] // self.width
        node = divide(self.expect(v, axis)[0] >> 4, self.width) + unzigzag(self.nodes[axis].decode(self.coder))
        must(0 <= node <= most, "VOX-5", f"node {node}")
        return node

    def VOX_6_level(self, k, at, cube):
        if self.levels == 1:
            return 0
        t = p = 0
        if cube:
            t, E, F = cube.M[k], [b - a for a, b in zip(cube.A, cube.B)], [x - a for a, x in zip(cube.A, cube.X)]
            N = [E[(i + 1) % 3] * F[(i + 2) % 3] - E[(i + 2) % 3] * F[(i + 1) % 3] for i in range(3)]
            d = [0 if i == k else 64 if at[i] else -64 for i in range(3)]
            above = sum(x * y for x, y in zip(N, d)) - sum(x * y for x, y in zip(N, cube.A))
            p = divide(-above, N[k] or 1)
        h = self.coder.symbol([self.level_models[20 * clamp((t + 80) >> 3, 0, 19) + clamp((p + 80) >> 3, 0, 19)]])
        low = self.coder.raw(self.low) if self.low else 0
        level = h << self.low | low
        must(level < self.levels, "VOX-6", f"level {level}")
        return level

    def anywhere(self, v):
        """[VOX-1] Start symbol 3."""
        known = self.known[v]
        G, R = self.kept.sums(known.faces)
        c = len(known.parallelograms)
        sources = min(c, 3) + 1 if c else int(bool(known.faces))
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
        voxels.step(i)
    return [voxels.rows[v] for v in range(n)]
