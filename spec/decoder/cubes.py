"""Nodes, cubes, bricks and edges: grid.md, GRD-1 and GRD-6. Nodes, and cubes by their lowest nodes, are triples; an edge is a pair of its axis and its first node."""

def moved(node, axis, by):  # GRD-1
    return tuple(x + by * (a == axis) for a, x in enumerate(node))

def corner_of(cube, i):  # GRD-1
    return cube[0] + (i & 1), cube[1] + (i >> 1 & 1), cube[2] + (i >> 2)

def brick_of(node):  # GRD-1
    return tuple(x >> 4 for x in node)

def edge_of(cube, number):  # GRD-1
    """The edge of a cube that has this number."""
    k, i = divmod(number, 4)
    return k, moved(moved(cube, (k + 1) % 3, i & 1), (k + 2) % 3, i >> 1)

def first_corner(number):  # GRD-1
    k, i = divmod(number, 4)
    return (i & 1) << (k + 1) % 3 | (i >> 1) << (k + 2) % 3

def edge_between(a, b):  # GRD-1
    return next(e for e in range(12) if {a, b} == {first_corner(e), first_corner(e) | 1 << e // 4})

def face_corners(axis, high):  # GRD-6
    """Around a face of the cube, seen from outside."""
    i, j, base = 1 << (axis + 1) % 3, 1 << (axis + 2) % 3, high << axis
    return [base, base | (i if high else j), base | i | j, base | (j if high else i)]

FACES = [face_corners(axis, high) for axis in range(3) for high in (0, 1)]
