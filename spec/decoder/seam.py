"""SEAM: which corners use which copy of a geometric vertex: seam.md."""
from coder import Coder, NumberModel, mixing_weights, symbol_models
from container import Reader, must


class Seams:
    """[SEAM-5] `faces` over vertices; `first[g]` is the first copy of geometric vertex g, `geometric[v]` that of v."""

    def __init__(self, copies, corners, faces):
        self.first = [0]
        for count in copies:
            self.first.append(self.first[-1] + count)
        self.geometric = [g for g, count in enumerate(copies) for _ in range(count)]
        self.faces = [tuple(self.first[g] + corners[3 * f + k] for k, g in enumerate(face)) for f, face in enumerate(faces)]


def SEAM_1_read(chunk, faces, n_g, n):
    data = chunk.data if chunk else b""
    must((n == n_g) == (not data), "SEAM-1", "the chunk is there without copies, or not with them")
    if not data:
        return Seams([1] * n_g, [0] * (3 * len(faces)), faces)
    copies, corners = (SEAM_6_compact if chunk.is_compact else SEAM_2_plain)(data, faces, n_g, n)
    return Seams(copies, corners, faces)


def SEAM_2_plain(data, faces, n_g, n):
    r = Reader(data)
    K = r.varint()
    must(1 <= K <= min(n_g, n - n_g), "SEAM-2", f"{K} split vertices")
    copies, g, total = [1] * n_g, -1, 0
    corners_of = [0] * n_g
    for face in faces:
        for x in face:
            corners_of[x] += 1
    gaps, numbers = r.planes(K), r.planes(K)
    choices = 0
    for gap, number in zip(gaps, numbers):
        g += gap + 1
        must(g < n_g, "SEAM-2", "a split vertex is out of range")
        copies[g] = number + 2
        total += number + 1
        must(corners_of[g] >= copies[g], "SEAM-3", "more copies than corners")
        choices += corners_of[g] - 1
    must(total == n - n_g, "SEAM-3", "the numbers of copies do not add up")
    result = SEAM_4_corners(iter(r.planes(choices)), faces, copies)
    r.end()
    return copies, result


def SEAM_4_corners(choices, faces, copies):
    state, corners = {}, []  # of a split vertex: present, other, used
    for x in (x for face in faces for x in face):
        if copies[x] == 1:
            corners.append(0)
            continue
        if x not in state:
            state[x] = (0, 0, 1)
            corners.append(0)
            continue
        present, other, used = state[x]
        choice = next(choices)
        if choice == 0:
            copy = present
        elif choice == 1:
            copy = used
            must(used < copies[x], "SEAM-4", "a copy more than stated")
            used += 1
        elif choice == 2:
            copy = other
        else:
            copy = choice - 3
            must(copy < used, "SEAM-4", "a copy that was not used yet")
        state[x] = (copy, present, used) if copy != present else (present, other, used)
        corners.append(copy)
    must(all(state[x][2] == copies[x] for x in range(len(copies)) if copies[x] > 1), "SEAM-4", "a copy is not used")
    return corners


class Vertex:
    """[SEAM-6, SEAM-7] What is known of a geometric vertex that was met."""

    def __init__(self, copies):
        self.copies, self.used, self.last, self.split_neighbours = copies, 0, 0, 0
        self.open = []  # the other end, the copy here, the copy there; the oldest first

    def oldest(self, other):
        return next((edge for edge in self.open if edge[0] == other), None)

    def join(self, other, here, there, is_split):
        edge = self.oldest(other)
        if edge:
            self.open.remove(edge)
            return
        if len(self.open) == 6:
            self.open.pop(0)
        self.open.append((other, here, there))
        self.split_neighbours += is_split


def SEAM_6_compact(data, faces, n_g, n):
    coder = Coder(data)
    must(n - n_g <= 3 * len(faces), "SEAM-6", "more copies than corners")
    counts = symbol_models((60, 10, 3) + (1,) * 13)
    choice_models, choice_weights = symbol_models((60, 10, 10) + (1,) * 13), mixing_weights(2)
    large = NumberModel()
    met, corners, extra = {}, [], 0

    def with_rest(s):
        return s if s < 15 else 15 + large.decode(coder)

    def kind_of(x):
        v = met.get(x)
        return 0 if v is None else 1 if v.copies == 1 else 2 + min(v.split_neighbours, 2)

    for face in faces:
        used = []
        for k, x in enumerate(face):
            after, before = face[(k + 1) % 3], face[(k + 2) % 3]
            if x not in met:
                count = with_rest(coder.symbol([counts[5 * kind_of(after) + kind_of(before)]]))
                extra += count
                must(extra <= n - n_g, "SEAM-6", "the numbers of copies add up to too much")
                met[x] = Vertex(count + 1)
            used.append(SEAM_8_corner(coder, met, face, k, used, choice_models, choice_weights, with_rest))
        corners += used
        for k, x in enumerate(face):
            if met[x].copies > 1:
                for j in ((k + 1) % 3, (k + 2) % 3):
                    met[x].join(face[j], used[k], used[j], met[face[j]].copies > 1)
    must(extra == n - n_g, "SEAM-6", "the numbers of copies do not add up")
    must(all(v.used == v.copies for v in met.values()), "SEAM-8", "a copy is not used")
    coder.end()
    return [met[g].copies if g in met else 1 for g in range(n_g)], corners


def SEAM_8_corner(coder, met, face, k, used, models, weights, with_rest):
    """The copy that corner k uses."""
    v = met[face[k]]
    if v.copies == 1 or v.used == 0:
        v.used, v.last = 1, 0
        return 0

    def kind(edge, j):  # [SEAM-7]
        if edge is None:
            return 0
        if met[edge[0]].copies == 1:
            return 1
        return 2 if j >= len(used) else 3 if used[j] == edge[2] else 4

    j_ahead, j_behind = (k + 1) % 3, (k + 2) % 3
    ahead, behind = v.oldest(face[j_ahead]), v.oldest(face[j_behind])
    second = behind[1] if behind else v.last
    first = ahead[1] if ahead else second
    t = 2 * (first != second) + (v.used < v.copies)
    models = [models[0, 20 * kind(ahead, j_ahead) + 4 * kind(behind, j_behind) + t],
              models[1, 16 * min(v.copies - 2, 3) + 4 * min(v.used - 1, 3) + t]]
    choice = with_rest(coder.symbol(models, weights[t]))
    copy = (first, second, v.used)[choice] if choice < 3 else choice - 3
    must(copy <= v.used and copy < v.copies, "SEAM-8", f"copy {copy}")
    v.used += copy == v.used
    v.last = copy
    return copy
