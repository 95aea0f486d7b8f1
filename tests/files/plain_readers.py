"""Readers of small OBJ, OFF, text PLY and text STL files: read(format, bytes) gives (vertices, triangles, whether no polygon is larger)."""
import math
import re
import struct

from plain_text import count, integer, lines_of, need, number

OTHER = set('''vp cstype deg bmat step curv curv2 surf parm trim hole scrv sp end con mg bevel lod maplib usemap call csh ctech stech
    c_interp d_interp bsp bzp cdc cdp res shadow_obj trace_obj l p s mtllib o g usemtl'''.split())


def fans(faces):
    return [[f[0], f[i - 1], f[i]] for f in faces for i in range(2, len(f))]


def split(points, faces, kinds):
    """One vertex for every distinct corner: (position, others...)."""
    points, own, known, result = list(points), set(), {}, []
    for face in faces:
        if len(face) < 3:
            continue
        for corner in face:
            if corner[:kinds] in known:
                continue
            if corner[0] in own:
                known[corner[:kinds]] = len(points)
                points.append(points[corner[0]])
            else:
                own.add(corner[0])
                known[corner[:kinds]] = corner[0]
        result.append([known[corner[:kinds]] for corner in face])
    return points, result


def read_obj(data):
    points, counts, faces, colored = [], {'v': 0, 'vt': 0, 'vn': 0}, [], 0
    for line in lines_of(data, comments=True, joins=True):
        if not line:
            continue
        word, rest = line[0], line[1:]
        if word in counts:
            numbers = [number(text) for text in rest]
            need(len(numbers) in {'v': (3, 4, 6, 7), 'vt': (1, 2, 3), 'vn': (3,)}[word])
            counts[word] += 1
            if word == 'v':
                points.append(numbers[:3])
        elif word in ('f', 'fo'):
            face = []
            for text in rest:
                parts = text.split('/')
                if len(parts) == 4 and parts[3] == '':
                    parts.pop()  # "1/2/3/" is read, too
                need(len(parts) <= 3 and parts[0])
                corner = []
                for part, kind in zip(parts + ['', ''], ('v', 'vt', 'vn')):
                    index = integer(part) if part else 0
                    need(not part or index != 0)
                    corner.append(index + counts[kind] if index < 0 else index - 1)
                    need(not part or corner[-1] >= 0)
                face.append(tuple(corner))
            faces.append(face)
        else:
            need(word in OTHER)
    for face in faces:
        for corner in face:
            need(all(index < most for index, most in zip(corner, counts.values())))
    kept = [face for face in faces if len(face) >= 3]
    normals = all(corner[2] >= 0 for face in kept for corner in face)
    # Normals that not all corners have are left out.
    return split(points, faces if normals else [[c[:2] for c in f] for f in faces], 3)


def read_off(data):
    rows = lines_of(data, comments=True)
    tokens = [(word, row) for row, line in enumerate(rows) for word in line]
    at = 0

    def take():
        nonlocal at
        need(at < len(tokens))
        at += 1
        return tokens[at - 1][0]

    def rest_of_line():
        nonlocal at
        rest = []
        while at < len(tokens) and at > 0 and tokens[at][1] == tokens[at - 1][1]:
            rest.append(take())
        return rest

    magic = re.fullmatch('((?:ST|C|N)*)OFF(.*)', take())
    need(magic and len(re.findall('ST|C|N', magic[1])) == len(set(re.findall('ST|C|N', magic[1]))))
    vertices = count(magic[2] or take())
    faces = count(take())
    edges = rest_of_line()
    need(len(edges) <= 1)
    for word in edges:
        integer(word)
    normal, uv, color = 3 * ('N' in magic[1]), 2 * ('ST' in magic[1]), 'C' in magic[1]
    points, colors = [], set()
    for _ in range(vertices):
        points.append([number(take()) for _ in range(3)])
        rest = [number(text) for text in rest_of_line()]
        need(len(rest) <= 9)
        if magic[1]:
            need(len(rest) - normal - uv in ((3, 4) if color else (0,)))
            colors.add(len(rest))
    need(len(colors) <= 1)
    polygons = []
    for _ in range(faces):
        polygons.append([count(take()) for _ in range(count(take()))])
        need(all(index < vertices for index in polygons[-1]))
        rest = [number(text) for text in rest_of_line()]
        need(len(rest) in (0, 1, 3, 4))
        polygons[-1] = [(index, tuple(rest)) for index in polygons[-1]]
    need(at == len(tokens))
    # Colours that all faces have are values of their corners, where the vertices have none.
    sizes = {len(face[0][1]) for face in polygons if len(face) >= 3}
    return split(points, polygons, 2 if not color and sizes in ({3}, {4}) else 1)


TYPES = {'char': (-2**7, 2**7), 'uchar': (0, 2**8), 'short': (-2**15, 2**15), 'ushort': (0, 2**16), 'int': (-2**31, 2**31),
         'uint': (0, 2**32), 'float': None, 'double': None}
SIZED = dict(zip(('int8', 'uint8', 'int16', 'uint16', 'int32', 'uint32', 'float32', 'float64'), TYPES))


def kind(name):
    name = SIZED.get(name, name)
    need(name in TYPES)
    return name


def read_ply(data):
    rows = lines_of(data)
    need(rows and rows[0] == ['ply'])
    elements, has_format, row = [], False, 1
    while True:
        need(row < len(rows) - 1 or (row < len(rows) and rows[row][:1] == ['end_header'] and data[-1:] in b'\r\n\0'))
        line = rows[row]
        row += 1
        if not line or line[0] in ('comment', 'obj_info'):
            continue
        if line[0] == 'format':
            need(line[1:] == ['ascii', '1.0'])
            has_format = True
        elif line[0] == 'element':
            need(len(line) == 3)
            need(0 <= integer(line[2]))
            elements.append((line[1], int(line[2]), []))
        elif line[0] == 'property':
            need(elements)
            if line[1:2] == ['list']:
                need(len(line) == 5 and TYPES[kind(line[2])])
                elements[-1][2].append((line[4], kind(line[3]), kind(line[2])))
            else:
                need(len(line) == 3)
                elements[-1][2].append((line[2], kind(line[1]), None))
        else:
            need(line == ['end_header'] and has_format)
            break
    tokens = [(word, at) for at, line in enumerate(rows) if at >= row for word in line]
    at = 0

    def take(name):
        nonlocal at
        need(at < len(tokens))
        value = number(tokens[at][0])
        at += 1
        if TYPES[name]:
            need(TYPES[name][0] - 1 < value < TYPES[name][1])
        return value

    points, faces, names = [], [], [name for name, _, _ in elements]
    need('vertex' in names)
    vertices = elements[names.index('vertex')][1]
    for number_of, (name, rows_of, properties) in enumerate(elements):
        first = names.index(name) == number_of
        if name == 'vertex' and first:
            scalars = [p for p, _, length in properties if length is None]
            need(all(axis in scalars for axis in 'xyz'))
        corner_list = [i for i, p in enumerate(properties) if p[2] and p[0] in ('vertex_indices', 'vertex_index')][:1]
        need(corner_list or name != 'face' or not first)
        for _ in range(rows_of if properties else 0):
            values = []
            for _, of, length in properties:
                size = take(length) if length else 1
                need(size >= 0 and size == math.floor(size))
                taken = [take(of) for _ in range(int(size))]
                values.append(taken)
            need(at == len(tokens) or tokens[at][1] != tokens[at - 1][1])
            if name == 'vertex' and first:
                flat = {p[0]: v[0] for p, v in reversed(list(zip(properties, values))) if not p[2]}
                points.append([flat[axis] for axis in 'xyz'])
            elif name == 'face' and first:
                face = values[corner_list[0]]
                need(all(0 <= index < vertices and index == math.floor(index) for index in face))
                faces.append([int(index) for index in face])
    need(at == len(tokens))
    return points, faces


def read_stl(data):
    rows = [[word.lower() for word in line] for line in lines_of(data)]
    tokens = [(word, row) for row, line in enumerate(rows) for word in line]
    need(tokens and tokens[0][0].startswith('solid'))
    end = len(data.rstrip(b'\0'))
    need(b'\0' not in data[:min(1024, end)])
    at, corners = 0, []

    def take():
        nonlocal at
        need(at < len(tokens))
        at += 1
        return tokens[at - 1][0]

    while at < len(tokens):
        word = take()
        if word in ('solid', 'endsolid'):
            row = tokens[at - 1][1]
            while at < len(tokens) and tokens[at][1] == row and tokens[at][0] not in ('solid', 'endsolid') and not (
                    tokens[at][0] == 'facet' and tokens[at + 1:] and tokens[at + 1][0] == 'normal'):
                at += 1
        else:
            need(word == 'facet' and take() == 'normal')
            for _ in range(3):
                take()
            need(take() == 'outer' and take() == 'loop')
            for _ in range(3):
                need(take() == 'vertex')
                corners.append(tuple(number(take()) + 0.0 for _ in range(3)))
            need(take() == 'endloop' and take() == 'endfacet')
    known = {}
    faces = [[known.setdefault(c, len(known)) for c in corners[i:i + 3]] for i in range(0, len(corners), 3)]
    return [list(point) for point in known], faces


def as_float(x):
    return math.copysign(math.inf, x) if abs(x) > 3.4028234663852886e38 else struct.unpack('f', struct.pack('f', x))[0]


def read(file_format, data):
    points, faces = {'obj': read_obj, 'off': read_off, 'ply': read_ply, 'stl': read_stl}[file_format](data)
    triangles = fans(faces)
    # What is not finite goes where nothing uses it.
    points = [[as_float(x) for x in point] for point in points]
    used = {index for triangle in triangles for index in triangle}
    kept = [i for i, point in enumerate(points) if i in used or all(map(math.isfinite, point))]
    renamed = {old: new for new, old in enumerate(kept)}
    fanned = all(len(face) <= 3 for face in faces)
    return [points[i] for i in kept], [[renamed[i] for i in triangle] for triangle in triangles], fanned
