"""CONN: gluing manifold vertices to geometric vertices: conn.md, CONN-8, CONN-11, CONN-13 and CONN-14."""
from coder import NumberModel, bit_models, symbol_models
from conn import Ops, Traversal
from container import must, unzigzag

def CONN_8_faces(chunk, m, n, states):
    """The faces over geometric vertices, as triples."""
    if m == 0:
        chunk.end()
        return []
    ops = Ops(chunk, m, states)
    traversal = Traversal(m, ops)
    M, G = traversal.manifold, NumberModel().decode(ops.coder)
    must(G <= M, "CONN-11", f"{G} of {M} are glued")
    must(M - G <= n, "CONN-11", f"{M - G} geometric vertices in place of {n}")
    vertex_of = CONN_13_glue(ops.coder, traversal, G)
    chunk.end()
    return [tuple(vertex_of[x] for x in face) for face in traversal.faces]

def CONN_11_glue(pairs, M):
    """The vertex of every manifold vertex, from gaps and targets of the glued ones."""
    vertex_of, fresh, target = [], 0, 0
    for gap, code in pairs:
        must(len(vertex_of) + gap < M, "CONN-11", "a glued vertex is not below M")
        vertex_of += range(fresh, fresh + gap)
        fresh, target = fresh + gap, (target + unzigzag(code)) % 2**32
        must(target < fresh, "CONN-11", "glued to a vertex that is not there yet")
        vertex_of.append(target)
    return vertex_of + list(range(fresh, fresh + M - len(vertex_of)))

def CONN_13_glue(coder, traversal, G):
    if 16 * G > traversal.manifold:
        return CONN_14_glue(coder, traversal, G)
    gaps, targets = NumberModel(), NumberModel()
    return CONN_11_glue([(gaps.decode(coder), targets.decode(coder)) for _ in range(G)], traversal.manifold)

def CONN_14_glue(coder, traversal, G):
    edges, vertex_of, is_glued = {}, {}, {}  # edges[x, y]: the opposite vertices of the faces with this edge
    glued_bits, kinds, numbers = bit_models(), symbol_models((4, 4, 4) + (1,) * 13), NumberModel()
    fresh = last = 0
    for face in traversal.faces:
        for corner, x in enumerate(face):
            if x in vertex_of:
                continue
            same = mirrored = ()
            if corner == 2:
                a, b = vertex_of[face[0]], vertex_of[face[1]]
                same, mirrored = edges.get((a, b), ()), edges.get((b, a), ())
            k, count = bool(same) + 2 * (len(mirrored) >= 2), is_glued[face[0]] + is_glued[face[1]] if corner == 2 else 0
            is_glued[x] = glued_bits[4 * count + k].decode(coder)
            if not is_glued[x]:
                vertex_of[x], fresh = fresh, fresh + 1
                continue
            kind = coder.symbol([kinds[k]])
            must(kind <= 2, "CONN-14", f"kind {kind}")
            must(kind == 2 or k >> kind & 1, "CONN-14", f"kind {kind} without a guess")
            last = (last + unzigzag(numbers.decode(coder))) % 2**32 if kind == 2 else (same, mirrored)[kind][0]
            must(last < fresh, "CONN-14", "glued to a vertex that is not there yet")
            vertex_of[x] = last
        a, b, c = (vertex_of[x] for x in face)
        for x, y, opposite in ((a, b, c), (b, c, a), (c, a, b)):
            edges.setdefault((x, y), []).append(opposite)
    must(sum(is_glued.values()) == G, "CONN-14", f"not {G} are glued")
    return vertex_of
