"""Neighbours, components and corners of faces over vertices."""

def neighbours(faces, n):
    """N(v), ascending: the vertices that share an edge with v, each once, never v itself."""
    around = [set() for _ in range(n)]
    for a, b, c in faces:
        around[a].update((b, c))
        around[b].update((c, a))
        around[c].update((a, b))
    return [sorted(s - {v}) for v, s in enumerate(around)]

def components(around):
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

def subgraph(around, vertices):
    """The neighbours of these vertices, which count from 0."""
    number = {v: i for i, v in enumerate(vertices)}
    return [[number[u] for u in around[v]] for v in vertices]

def corners(faces, n):
    """The corners 3 f + k at every vertex, ascending."""
    at = [[] for _ in range(n)]
    for f, face in enumerate(faces):
        for k, v in enumerate(face):
            at[v].append(3 * f + k)
    return at

def others(faces, corner):
    """The vertices at the next corner of a corner's face and at the one before."""
    f, k = divmod(corner, 3)
    return faces[f][(k + 1) % 3], faces[f][(k + 2) % 3]

def open_edges(faces, n):
    """[MAP-11] For every vertex the other ends of its open edges, ascending."""
    count, result = {}, [[] for _ in range(n)]
    for edge in (tuple(sorted((face[k], face[k - 1]))) for face in faces for k in range(3)):
        count[edge] = count.get(edge, 0) + 1
    for a, b in sorted(edge for edge, faces in count.items() if faces == 1 and edge[0] != edge[1]):
        result[a].append(b)
        result[b].append(a)
    return [sorted(ends) for ends in result]
