"""Voxel edges: posn_voxels.md, POSN-12 and VOX-1 to VOX-6. An edge is a pair of its axis and its node."""
from coder import NumberModel, SymbolModel, clamp, divide, symbol_models
from container import must, unzigzag
from lattice import POSN_2_positions, POSN_3_known, POSN_4_expect, POSN_8_table, PredictedCoder

def VOX_direction(number):  # VOX-2
    """Where the middle of a cube's edge is from the cube's centre."""
    (k, i), d = divmod(number, 4), [0, 0, 0]
    d[(k + 1) % 3], d[(k + 2) % 3] = 2 * (i % 2) - 1, 2 * (i // 2) - 1
    return tuple(d)

NUMBERS = {VOX_direction(e): e for e in range(12)}

def VOX_rotations():  # VOX-2
    """For each of the 24 rotations the number of every edge after it."""
    for index, p in enumerate(((0, 1, 2), (1, 2, 0), (2, 0, 1), (0, 2, 1), (2, 1, 0), (1, 0, 2))):
        for signs in range(8):
            if bin(signs).count("1") % 2 == (index >= 3):
                yield [NUMBERS[tuple((-1 if signs >> a & 1 else 1) * VOX_direction(e)[p[a]] for a in range(3))] for e in range(12)]

ROTATIONS = list(VOX_rotations())

def edge_of(number, cube):  # VOX-2
    return number // 4, tuple(x + (d > 0) for x, d in zip(cube, VOX_direction(number)))

def cubes_of(edge):  # VOX-2, VOX-3
    """The lowest nodes of the four cubes that have an edge."""
    axis, cubes = edge[0], [edge[1]]
    for i in {0, 1, 2} - {axis}:
        cubes += [tuple(x - (j == i) for j, x in enumerate(cube)) for cube in cubes]
    return cubes

def shared(x, y):  # VOX-2, VOX-3
    """The cubes that have both edges, the lower one first."""
    return sorted(set(cubes_of(x)) & set(cubes_of(y)))

class Cube:
    """[VOX-2] What is known of a vertex that has a cube."""
    def __init__(self, edge, spots, corners, upper):
        a, b, c, d, o = corners
        common = shared(edge[a], edge[b])
        self.node, other, self.open = common[0], common[-1], False
        if len(common) == 2:
            axis = [x != y for x, y in zip(*common)].index(True)
            side = spots[o][axis] - 128 * common[1][axis] if o is not None else 0
            self.open = side == 0 and not upper
            if side < 0 or upper:
                self.node, other = other, self.node
        own, of_other = ([edge_of(e, cube) for e in range(12)] for cube in (self.node, other))
        e_a, e_b = own.index(edge[a]), own.index(edge[b])
        self.rotation = min((t for t in ROTATIONS if t[e_a] == 0), key=lambda t: t[e_b])
        kind = (1, 3, 4, 5, 6, 7).index(self.rotation[e_b])
        e_o = of_other.index(edge[o]) if o is not None and edge[o] in of_other else None
        opposite = 13 if self.open else 12 if e_o is None else self.rotation[e_o]
        spots = [u if u is None else [s - 128 * x - 64 for s, x in zip(spots[u], self.node)] for u in corners]  # [VOX-3]
        self.A, self.B, self.M = spots[0], spots[1], [sum(x) >> 2 for x in zip(*spots[:4])]
        self.X = self.M
        if o is not None:
            self.X = [m + ((5 * (a + b - x - m)) >> 3) for m, a, b, x in zip(self.M, self.A, self.B, spots[4])]
        ends = [edge[u] for u in corners[:4]]
        near = [i for i, e in enumerate(own) if e not in ends and shared(e, ends[2]) and shared(e, ends[3])]
        likely = frozenset(self.rotation[i] for i in near)
        self.model = kind, likely, opposite  # [VOX-4]
        self.weights = [20 if e in likely else 1 for e in range(12)] + [1, 100 if opposite == 13 else 0, 0, 0]

class VoxelCoder(PredictedCoder):  # VOX-1 to VOX-6
    def __init__(self, coder, known, half, header, states):
        super().__init__(coder, known, POSN_8_table(None), header.cells, states=states)
        self.starts, self.levels, self.width, self.edges, self.spots = (0, half), header.levels, 2 * header.levels, {}, {}
        start, nodes = SymbolModel((8,) * 4 + (1,) * 12), [NumberModel() for _ in range(3)]
        self.voxels = states.models("voxels", start=start, nodes=nodes, edges={})
        self.low = max((header.levels - 1).bit_length() - 4, 0)  # g
        levels = symbol_models([int(h <= (header.levels - 1) >> self.low) for h in range(16)])
        self.level_models = states.models(header.levels, levels=levels).levels

    def VOX_2_corners(self, v):
        """The corners a, b, c, d and o (or None); None without a cube."""
        def near(u):
            return u in self.edges and max(abs(x - y) for x, y in zip(self.edges[u][1], self.edges[a][1])) <= 2
        edge, faces = self.edges, self.known[v].faces
        if not faces:
            return None
        (a, b, o), (c, d, _) = faces[0], faces[-1]
        if a not in edge or b not in edge or edge[a] == edge[b] or not shared(edge[a], edge[b]):
            return None
        return (a, b) + ((c, d) if near(c) and near(d) else (a, b)) + (o if near(o) else None,)

    def VOX_4_symbol(self, corners):
        """The cube and the edge symbol."""
        for upper in (False, True):
            cube = Cube(self.edges, self.spots, corners, upper)
            symbol = self.coder.symbol([self.voxels.edges.setdefault(cube.model, SymbolModel(cube.weights))])
            if not (symbol == 13 and cube.open):
                break
        must(not upper or symbol <= 12, "VOX-4", f"edge symbol {symbol} after 13")
        must(symbol <= 12, "VOX-4", f"edge symbol {symbol}")
        return cube, symbol

    def VOX_1_vertex(self, v):
        corners = self.VOX_2_corners(v)
        cube, symbol = self.VOX_4_symbol(corners) if corners else (None, 12)
        if symbol < 12:
            number = cube.rotation.index(symbol)
            axis, node = edge_of(number, cube.node)
            level = self.VOX_6_level(axis, cube, number)
        else:
            axis = self.coder.symbol([self.voxels.start])
            must(axis <= 3, "VOX-1", f"start symbol {axis}")
            if axis == 3:
                self.decode(v)
                return
            node = [self.VOX_5_node(v, a) for a in range(3)]
            level = self.VOX_6_level(axis)
        row, spot = [x * self.width for x in node], [128 * x for x in node]
        row[axis] += 2 * level + 1
        spot[axis] += 64 * (2 * level + 1) // self.levels
        must(all(low <= q <= most for q, (low, most) in zip(row, self.limits)), "POSN-7", f"coordinates {row}")
        self.rows[v], self.edges[v], self.spots[v] = row, (axis, tuple(node)), spot
        self.sizes[v] = self.residuals[v] = [0] * 3

    def VOX_5_node(self, v, axis):
        place, _ = POSN_4_expect(self.known[v], self.table, lambda u: self.rows[u][axis], self.before(v)[axis])
        node = divide(place >> 4, self.width) + unzigzag(self.voxels.nodes[axis].decode(self.coder))
        must(0 <= node <= self.limits[axis][1] // self.width, "VOX-5", f"node {node}")
        return node

    def VOX_6_level(self, k, cube=None, number=0):
        if self.levels == 1:
            return 0
        t = p = 0
        if cube:
            t, E, F = cube.M[k], [b - a for a, b in zip(cube.A, cube.B)], [x - a for a, x in zip(cube.A, cube.X)]
            N = [E[(i + 1) % 3] * F[(i + 2) % 3] - E[(i + 2) % 3] * F[(i + 1) % 3] for i in range(3)]
            p = -divide(sum(x * (64 * y - a) for x, y, a in zip(N, VOX_direction(number), cube.A)), N[k] or 1)
        level = self.coder.symbol([self.level_models[20 * clamp((t + 80) >> 3, 0, 19) + clamp((p + 80) >> 3, 0, 19)]])
        level = level << self.low | self.coder.raw(self.low) if self.low else level
        must(level < self.levels, "VOX-6", f"level {level}")
        return level

def VOX_1_positions(coder, faces, n, header, states):
    """[POSN-12]"""
    half = n if states.is_next else (n + 1) // 2
    steps = [v % half for v in range(n)]
    voxels = VoxelCoder(coder, POSN_3_known(faces, n, steps), half, header, states)
    for v in sorted(range(n), key=lambda v: steps[v]):
        voxels.VOX_1_vertex(v)
    return POSN_2_positions(voxels.rows, header)
