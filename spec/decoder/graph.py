"""Neighbours, components and corners of faces over vertices."""

def neighbours(faces, n):  # DELT-4, FLD-13, ATTR-47
    """N(v), ascending: the vertices that share an edge with v, each once, never v itself."""
    around = [set() for _ in range(n)]
    for a, b, c in faces:
        around[a].update((b, c))
        around[b].update((c, a))
        around[c].update((a, b))
    return [sorted(s - {v}) for v, s in enumerate(around)]

def components(around):  # HDR-7, ANCH-2, DELT-7
    """Lists of vertices, ascending, one for each connected component, by their first vertices."""
    seen, result = [False] * len(around), []
    for start in range(len(around)):
        if seen[start]:
            continue
        seen[start], found = True, [start]
        for v in found:
            for u in around[v]:
                if not seen[u]:
                    seen[u] = True
                    found.append(u)
        result.append(sorted(found))
    return result

def subgraph(around, vertices):  # DELT-4, DELT-5, DELT-7
    """The neighbours of these vertices, which count from 0."""
    number = {v: i for i, v in enumerate(vertices)}
    return [[number[u] for u in around[v]] for v in vertices]

def corners(faces, n):  # POSN-3, POSN-10, ATTR-21, ATTR-30
    """The corners at every vertex, ascending: the face, the vertices at its next corner and at the one before."""
    at = [[] for _ in range(n)]
    for f, (x, y, z) in enumerate(faces):
        for v, after, before in ((x, y, z), (y, z, x), (z, x, y)):
            at[v].append((f, after, before))
    return at

def open_edges(faces, n):
    """[MAP-11] For every vertex the other ends of its open edges, ascending."""
    count, result = {}, [[] for _ in range(n)]
    for edge in (tuple(sorted((face[k], face[k - 1]))) for face in faces for k in range(3)):
        count[edge] = count.get(edge, 0) + 1
    for a, b in sorted(edge for edge, faces in count.items() if faces == 1 and edge[0] != edge[1]):
        result[a].append(b)
        result[b].append(a)
    return [sorted(ends) for ends in result]

def MAP_11_ends(faces, n, chosen):  # MAP-11, MAP-17
    """Of each vertex: it, the chosen ones before it at its open edges, and a number for its model, None without open edges."""
    for v, ends in enumerate(open_edges(faces, n)):
        before = [u for u in ends if u < v]
        on = [u for u in before if u in chosen]
        yield v, on, (len(on) < len(before)) + 2 * min(len(on), 2) if ends else None
