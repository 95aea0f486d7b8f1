"""Writers and readers of mesh files with numpy alone, written from the formats' descriptions: for the tests of round trips.
A mesh is a dict: points (n x 3), faces (m x 3), and what else there is: normals (n x 3), colors (n x 3 or 4, bytes, as a screen shows them), uvs
(n x 2), groups (m names), and properties (name: n numbers)."""
import base64
import json
import struct

import numpy as np

PLY = {'i1': 'char', 'u1': 'uchar', 'i2': 'short', 'u2': 'ushort', 'i4': 'int', 'u4': 'uint', 'f4': 'float', 'f8': 'double'}
GLTF = {'i1': 5120, 'u1': 5121, 'i2': 5122, 'u2': 5123, 'u4': 5125, 'f4': 5126}


def linear(shown):
    return np.where(shown <= 0.04045, shown / 12.92, ((shown + 0.055) / 1.055) ** 2.4)


def shown(light):
    return np.where(light <= 0.0031308, light * 12.92, 1.055 * np.maximum(light, 0) ** (1 / 2.4) - 0.055)


def text(value):
    return repr(float(value)) if isinstance(value, np.floating) else str(value)


def columns(mesh):
    """Names and values of a PLY file's vertices."""
    result = {axis: mesh['points'][:, k] for k, axis in enumerate('xyz')}
    for key, names in (('normals', ('nx', 'ny', 'nz')), ('uvs', ('s', 't')), ('colors', ('red', 'green', 'blue', 'alpha'))):
        if key in mesh:
            result.update({name: values for name, values in zip(names, mesh[key].T)})
    return {**result, **mesh.get('properties', {})}


def write_ply(mesh, binary=True):
    vertices = columns(mesh)
    head = ['ply', f'format {"binary_little_endian" if binary else "ascii"} 1.0', f'element vertex {len(mesh["points"])}']
    head += [f'property {PLY[values.dtype.str[1:]]} {name}' for name, values in vertices.items()]
    head += [f'element face {len(mesh["faces"])}', 'property list uchar int vertex_indices', 'end_header\n']
    if not binary:
        rows = [' '.join(map(text, row)) for row in zip(*vertices.values())] + ['3 ' + ' '.join(map(str, f)) for f in mesh['faces']]
        return '\n'.join(head + rows).replace('\n\n', '\n').encode() + b'\n'
    table = np.zeros(len(mesh['points']), [(name, values.dtype) for name, values in vertices.items()])
    for name, values in vertices.items():
        table[name] = values
    faces = np.zeros(len(mesh['faces']), [('n', 'u1'), ('v', '<i4', 3)])
    faces['n'], faces['v'] = 3, mesh['faces']
    return '\n'.join(head).encode() + table.tobytes() + faces.tobytes()


def read_ply(data):
    end = data.index(b'end_header\n') + 11
    types = {name: kind for kind, name in PLY.items()}
    head = [line.split() for line in data[:end].decode().split('\n')]
    counts = [int(line[2]) for line in head if line[:1] == ['element']]
    names = [(line[2], '<' + types[line[1]]) for line in head if line[:1] == ['property'] and line[1] != 'list']
    table = np.frombuffer(data, np.dtype(names), counts[0], end)
    faces = np.frombuffer(data, [('n', 'u1'), ('v', '<u4', 3)], counts[1], end + table.nbytes)
    left = {name: table[name] for name, _ in names}
    mesh = {'faces': faces['v'].astype(int)}
    for key, group in (('points', 'x y z'), ('normals', 'nx ny nz'), ('uvs', 's t'), ('colors', 'red green blue alpha')):
        here = [left.pop(name) for name in group.split() if name in left]
        if here:
            mesh[key] = np.stack(here, 1)
    if 'colors' in mesh and mesh['colors'].dtype == np.float32:
        mesh['colors'] = mesh['colors'] * 255
    return {**mesh, 'properties': {name.lstrip('_'): values for name, values in left.items()}}


def write_obj(mesh):
    lines = []
    color = [' ' + ' '.join(text(x) for x in row) for row in np.float64(mesh['colors'][:, :3]) / 255] if 'colors' in mesh else [''] * len(mesh['points'])
    lines += ['v ' + ' '.join(map(text, p)) + c for p, c in zip(mesh['points'], color)]
    for key, word in (('uvs', 'vt'), ('normals', 'vn')):
        lines += [word + ' ' + ' '.join(map(text, row)) for row in mesh.get(key, [])]
    form = '{0}' + ('/{0}' if 'uvs' in mesh else '/' if 'normals' in mesh else '') + ('/{0}' if 'normals' in mesh else '')
    before = None
    for face, group in zip(mesh['faces'], mesh.get('groups', [None] * len(mesh['faces']))):
        if group != before:
            lines.append(f'usemtl {group}')
        before = group
        lines.append('f ' + ' '.join(form.format(v + 1) for v in face))
    return '\n'.join(lines).encode() + b'\n'


def read_obj(data):
    rows, faces, groups, material = {'v': [], 'vt': [], 'vn': []}, [], [], None
    for line in data.decode().splitlines():
        word, *rest = line.split()
        if word in rows:
            rows[word].append([float(x) for x in rest])
        elif word == 'usemtl':
            material = ' '.join(rest)
        elif word == 'f':
            faces.append([int(corner.split('/')[0]) - 1 for corner in rest])
            groups.append(material)
    v = np.array(rows['v'])
    mesh = {'points': v[:, :3], 'faces': np.array(faces), 'properties': {}}
    if v.shape[1] > 3:
        mesh['colors'] = v[:, 3:] * 255
    for key, word in (('uvs', 'vt'), ('normals', 'vn')):
        if rows[word]:
            mesh[key] = np.array(rows[word])
    return {**mesh, 'groups': groups} if material else mesh


def write_off(mesh):
    parts = [mesh['points']] + [mesh[key] for key in ('normals', 'colors', 'uvs') if key in mesh]
    head = 'ST' * ('uvs' in mesh) + 'C' * ('colors' in mesh) + 'N' * ('normals' in mesh) + 'OFF\n'
    lines = [' '.join(text(x) for part in parts for x in part[i]) for i in range(len(mesh['points']))]
    lines += ['3 ' + ' '.join(map(str, face)) for face in mesh['faces']]
    return (head + f'{len(mesh["points"])} {len(mesh["faces"])} 0\n' + '\n'.join(lines) + '\n').encode()


def read_off(data):
    head, counts, *lines = data.decode().splitlines()
    n = int(counts.split()[0])
    table = [line.split() for line in lines[:n]]
    mesh, at = {'faces': np.array([line.split()[1:] for line in lines[n:]], int), 'properties': {}}, 3
    rows = np.array(table, float)
    mesh['points'] = rows[:, :3]
    rest = rows.shape[1] - 3 - 3 * head.endswith('NOFF') - 2 * head.startswith('ST')
    for key, size in (('normals', 3 * head.endswith('NOFF')), ('colors', rest), ('uvs', 2 * head.startswith('ST'))):
        if size:
            mesh[key] = rows[:, at:at + size]
        if key == 'colors' and size and any('.' in x for x in table[0][at:at + size]):
            mesh[key] = mesh[key] * 255
        at += size
    return mesh


def write_stl(mesh):
    table = np.zeros(len(mesh['faces']), [('n', '<f4', 3), ('p', '<f4', (3, 3)), ('a', '<u2')])
    table['p'] = mesh['points'][mesh['faces']]
    return bytes(80) + struct.pack('<I', len(table)) + table.tobytes()


def read_stl(data):
    table = np.frombuffer(data, [('n', '<f4', 3), ('p', '<f4', (3, 3)), ('a', '<u2')], struct.unpack('<I', data[80:84])[0], 84)
    return {'points': table['p'].reshape(-1, 3), 'faces': np.arange(3 * len(table)).reshape(-1, 3), 'properties': {}}


class GltfWriter:
    def __init__(self):
        self.data, self.json = b'', {'asset': {'version': '2.0'}, 'bufferViews': [], 'accessors': []}

    def accessor(self, values, normalized=False):
        values = np.asarray(values)
        rows = values.reshape(len(values), -1)
        padded = np.zeros((len(rows), -(-rows.shape[1] * rows.itemsize // 4) * 4), np.uint8)
        padded[:, :rows.shape[1] * rows.itemsize] = np.ascontiguousarray(rows).view(np.uint8)
        is_index = values.ndim == 1 and values.dtype.str[1:] == 'u4'
        view = {'buffer': 0, 'byteOffset': len(self.data), 'byteLength': padded.nbytes}
        self.json['bufferViews'].append(view if is_index else {**view, 'byteStride': padded.shape[1]})
        entry = {'bufferView': len(self.json['bufferViews']) - 1, 'componentType': GLTF[values.dtype.str[1:]], 'count': len(rows),
                 'type': {1: 'SCALAR', 2: 'VEC2', 3: 'VEC3', 4: 'VEC4'}[rows.shape[1]], 'normalized': normalized}
        if values.dtype == np.float32 and rows.shape[1] == 3:
            entry.update(min=rows.min(0).tolist(), max=rows.max(0).tolist())
        self.data += padded.tobytes()
        self.json['accessors'].append(entry)
        return len(self.json['accessors']) - 1


def write_gltf(mesh, binary=False):
    w = GltfWriter()
    attributes = {'POSITION': w.accessor(mesh['points'].astype(np.float32))}
    if 'normals' in mesh:
        attributes['NORMAL'] = w.accessor(mesh['normals'])
    if 'uvs' in mesh:
        attributes['TEXCOORD_0'] = w.accessor(mesh['uvs'])
    if 'colors' in mesh:
        light = np.float64(mesh['colors']) / 255
        light[:, :3] = linear(light[:, :3])
        attributes['COLOR_0'] = w.accessor(np.round(light * 65535).astype(np.uint16), True)
    for name, values in mesh.get('properties', {}).items():
        attributes['_' + name] = w.accessor(values)
    names = list(dict.fromkeys(mesh.get('groups', [None])))
    groups = np.array([names.index(g) for g in mesh.get('groups', [None] * len(mesh['faces']))])
    primitives = [{'attributes': attributes, 'indices': w.accessor(mesh['faces'][groups == g].reshape(-1).astype(np.uint32)),
                   **({'material': g} if names[0] else {})} for g in range(len(names))]
    w.json.update(meshes=[{'primitives': primitives}], nodes=[{'mesh': 0}], scenes=[{'nodes': [0]}], scene=0)
    if names[0]:
        w.json['materials'] = [{'name': name} for name in names]
    buffer = {'byteLength': len(w.data)}
    if not binary:
        buffer['uri'] = 'data:application/octet-stream;base64,' + base64.b64encode(w.data).decode()
    text_ = json.dumps({**w.json, 'buffers': [buffer]}).encode()
    text_ += b' ' * (-len(text_) % 4)
    if not binary:
        return text_
    chunks = struct.pack('<II', len(text_), 0x4E4F534A) + text_ + struct.pack('<II', len(w.data), 0x004E4942) + w.data
    return struct.pack('<III', 0x46546C67, 2, 12 + len(chunks)) + chunks


def read_gltf(data):
    if data[:4] == b'glTF':
        size = struct.unpack('<I', data[12:16])[0]
        document, blob = json.loads(data[20:20 + size]), data[28 + size:]
    else:
        document = json.loads(data)
        blob = base64.b64decode(document['buffers'][0]['uri'].split(',')[1])
    types = {number: kind for kind, number in GLTF.items()}

    def values(number):
        a = document['accessors'][number]
        view, dtype = document['bufferViews'][a['bufferView']], np.dtype('<' + types[a['componentType']])
        k = {'SCALAR': 1, 'VEC2': 2, 'VEC3': 3, 'VEC4': 4}[a['type']]
        stride, start = view.get('byteStride') or k * dtype.itemsize, view.get('byteOffset', 0) + a.get('byteOffset', 0)
        rows = np.array([np.frombuffer(blob, dtype, k, start + i * stride) for i in range(a['count'])])
        return rows / (2 ** (8 * dtype.itemsize) - 1) if a.get('normalized') else rows

    [made], [node] = document['meshes'], document['nodes']
    attributes = {name: values(number) for name, number in made['primitives'][0]['attributes'].items()}
    mesh = {'points': attributes.pop('POSITION') + np.array(node.get('translation', [0.0] * 3)), 'faces': [], 'groups': []}
    for key, name in (('normals', 'NORMAL'), ('uvs', 'TEXCOORD_0'), ('colors', 'COLOR_0')):
        if name in attributes:
            mesh[key] = attributes.pop(name)
    if 'colors' in mesh:
        mesh['colors'] = np.concatenate([shown(mesh['colors'][:, :3]), mesh['colors'][:, 3:]], 1) * 255
    for primitive in made['primitives']:
        faces = values(primitive['indices']).reshape(-1, 3)
        mesh['faces'].append(faces)
        material = document['materials'][primitive['material']]['name'] if 'material' in primitive else None
        mesh['groups'] += [material] * len(faces)
    mesh['faces'] = np.concatenate(mesh['faces']).astype(int)
    if mesh['groups'][0] is None:
        del mesh['groups']
    return {**mesh, 'properties': {name.lstrip('_'): column.reshape(-1) for name, column in attributes.items()}}


WRITERS = {'ply': write_ply, 'obj': write_obj, 'off': write_off, 'stl': write_stl, 'gltf': write_gltf, 'glb': lambda mesh: write_gltf(mesh, True)}
READERS = {'ply': read_ply, 'obj': read_obj, 'off': read_off, 'stl': read_stl, 'gltf': read_gltf, 'glb': read_gltf}
