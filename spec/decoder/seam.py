"""SEAM: which corners use which copy of a geometric vertex: seam.md."""
from types import SimpleNamespace

from coder import Coder, Mixture, NumberModel, symbol_models
from container import must

def SEAM_1_read(chunk, faces, n_g, n):
    """[SEAM-5] `faces` over vertices; `first[g]`, the first copy of geometric vertex g; `geometric[v]`, that of v."""
    copies, corners = [1] * n_g, [0] * (3 * len(faces))
    must(n > n_g or not chunk.data, "SEAM-1", "the chunk is there without copies")
    must(n == n_g or chunk.data, "SEAM-1", "copies without the chunk")
    if chunk.data:
        copies, corners = SEAM_6_compact(chunk, faces, n_g, n)
        chunk.end()
    first = [0]
    for count in copies:
        first.append(first[-1] + count)
    return SimpleNamespace(first=first, geometric=[g for g, count in enumerate(copies) for _ in range(count)],
                           faces=[tuple(first[g] + corners[3 * f + k] for k, g in enumerate(face)) for f, face in enumerate(faces)])

class Vertex:
    """[SEAM-6, SEAM-7] What is known of a geometric vertex that was met."""
    def __init__(self, copies):
        self.copies, self.used, self.last, self.split_neighbours = copies, 0, 0, 0
        self.open = []  # the other end, the copy here, the copy there; the oldest first

    def oldest(self, other):  # SEAM-7, SEAM-8
        return next((edge for edge in self.open if edge[0] == other), None)

    def SEAM_7_join(self, other, here, there, is_split):
        edge = self.oldest(other)
        if edge:
            self.open.remove(edge)
        else:
            self.open = self.open[-5:] + [(other, here, there)]
            self.split_neighbours += is_split

class SEAM_6_Coder:
    def __init__(self, coder):
        self.coder, self.met, self.large = coder, {}, NumberModel()
        self.counts, self.choices = symbol_models((60, 10, 3) + (1,) * 13), Mixture((60, 10, 10) + (1,) * 13)

    def symbol(self, *models):
        s = self.coder.symbol(*models)
        return s if s < 15 else 15 + self.large.decode(self.coder)

    def class_of(self, x):
        v = self.met.get(x)
        return 0 if v is None else 1 if v.copies == 1 else 2 + min(v.split_neighbours, 2)

    def SEAM_7_kind(self, edge, used):
        """`used` is the copy that the corner at the other end uses, or None."""
        if edge is None:
            return 0
        return 1 if self.met[edge[0]].copies == 1 else 2 if used is None else 3 if used == edge[2] else 4

    def SEAM_8_corner(self, face, k, used):
        """The copy that corner k uses; `used` are those of corners 0, 1, 2, None for later ones."""
        v, after, before = self.met[face[k]], (k + 1) % 3, (k + 2) % 3
        if v.copies == 1 or v.used == 0:
            v.used = 1
            return 0
        ahead, behind = v.oldest(face[after]), v.oldest(face[before])
        second = behind[1] if behind else v.last
        first = ahead[1] if ahead else second
        t = 2 * (first != second) + (v.used < v.copies)
        A, B = self.SEAM_7_kind(ahead, used[after]), self.SEAM_7_kind(behind, used[before])
        choice = self.symbol(*self.choices.of(20 * A + 4 * B + t, 16 * min(v.copies - 2, 3) + 4 * min(v.used - 1, 3) + t, t))
        copy = (first, second, v.used)[choice] if choice < 3 else choice - 3
        must(copy <= v.used, "SEAM-8", f"copy {copy} after {v.used}")
        must(copy < v.copies, "SEAM-8", f"copy {copy} of {v.copies}")
        v.used, v.last = max(v.used, copy + 1), copy
        return copy

def SEAM_6_compact(chunk, faces, n_g, n):
    must(n - n_g <= 3 * len(faces), "SEAM-6", "more copies than corners")
    c, corners, extra = SEAM_6_Coder(Coder(chunk)), [], 0
    for face in faces:
        used = [None] * 3
        for k, x in enumerate(face):
            if x not in c.met:
                count = c.symbol([c.counts[5 * c.class_of(face[(k + 1) % 3]) + c.class_of(face[(k + 2) % 3])]])
                extra += count
                must(extra <= n - n_g, "SEAM-6", "the numbers of copies add up to too much")
                c.met[x] = Vertex(count + 1)
            used[k] = c.SEAM_8_corner(face, k, used)
        corners += used
        for k, x in enumerate(face):
            if c.met[x].copies > 1:
                for j in ((k + 1) % 3, (k + 2) % 3):
                    c.met[x].SEAM_7_join(face[j], used[k], used[j], c.met[face[j]].copies > 1)
    must(extra == n - n_g, "SEAM-6", "the numbers of copies do not add up")
    must(all(v.used == v.copies for v in c.met.values()), "SEAM-8", "a copy is not used")
    return [c.met[g].copies if g in c.met else 1 for g in range(n_g)], corners
