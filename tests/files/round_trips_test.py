"""round_trips_test.py PROGRAM: every property of 30 generated files, five of each format, through a stream into every format, all 36 pairs: it is
the same in the file that comes out, or it is in a list of what was left out. No third case."""
import json
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

from mesh_files import READERS, WRITERS

# What lists call a property, whatever the format that it came from.
NAMES = {'points': {'positions', 'x', 'y', 'z'}, 'normals': {'nx', 'vn', 'NORMAL', 'normal'}, 'uvs': {'s', 'vt', 'TEXCOORD_0', 'texcoord', 'uv'},
         'colors': {'red', 'rgb', 'COLOR_0', 'color', 'alpha'}, 'groups': {'groups'}}
HOLDS = {'ply': {'normals', 'colors', 'uvs', 'properties'}, 'obj': {'normals', 'colors', 'uvs', 'groups'}, 'off': {'normals', 'colors', 'uvs'},
         'stl': set(), 'gltf': {'normals', 'colors', 'uvs', 'groups', 'properties'}, 'glb': {'normals', 'colors', 'uvs', 'groups', 'properties'}}


def generated(file_format, number):
    """Larger with every number, and with more of what the format holds."""
    r, n = np.random.default_rng(number), 8 + 5 * number
    points = r.normal(size=(n, 3)).astype(np.float32)
    if number == 4 and file_format in ('ply', 'obj', 'off'):
        points = points.astype(np.float64) + (4e5, 5e6, 100)
    normals = r.normal(size=(n, 3))
    mesh = {'points': points, 'faces': np.array([r.permutation(n)[:3] for _ in range(2 * n)])}
    if number >= 1:
        mesh['normals'] = (normals / np.linalg.norm(normals, axis=1)[:, None]).astype(np.float32)
        mesh['uvs'] = r.random((n, 2)).astype(np.float32)
    if number >= 2:
        mesh['colors'] = r.integers(0, 256, (n, 3 if file_format == 'obj' or number == 2 else 4)).astype(np.uint8)
        mesh['groups'] = [f'part {f // 7 % 3}' for f in range(2 * n)]
    if number >= 3:
        mesh['properties'] = {'label': r.integers(-128, 128, n).astype(np.int8), 'intensity': r.random(n).astype(np.float32)}
    if number >= 3 and file_format == 'ply':
        mesh['properties'].update(stamp=r.random(n) * 1e9, id=r.integers(0, 2 ** 31, n).astype(np.int32))
    return {key: value for key, value in mesh.items() if key in ('points', 'faces') or key in HOLDS[file_format]}


def run(*arguments):
    done = subprocess.run([str(a) for a in arguments], capture_output=True, text=True)
    assert done.returncode == 0, (arguments, done.stderr)
    return json.loads(done.stdout)['left_out']


def corners(mesh, key):
    """Values at the corners of all faces, in the order of the groups where `mesh` says so."""
    values = mesh['properties'].get(key) if key in mesh.get('properties', {}) else mesh.get(key)
    if values is None:
        return None
    if key == 'groups':
        return np.array(values)
    return np.asarray(values)[np.asarray(mesh['faces'])]


def in_order_of_groups(mesh):
    groups = mesh.get('groups', [0] * len(mesh['faces']))
    order = np.argsort([list(dict.fromkeys(groups)).index(g) for g in groups], kind='stable')
    return {**mesh, 'faces': mesh['faces'][order], **({'groups': [groups[f] for f in order]} if 'groups' in mesh else {})}


def same(key, before, after, tolerance):
    if after is None:
        return False
    if key == 'groups':
        return np.array_equal(before, after)
    if before.shape != after.shape:
        return False
    if before.dtype == np.float32:
        after = after.astype(np.float32)
    return bool((np.abs(before.astype(float) - after.astype(float)) <= tolerance).all())


def check(program, folder, in_format, number, out_format):
    mesh = generated(in_format, number)
    source, stream, target = folder / f'in.{in_format}', folder / 'x.dmsh', folder / f'out.{out_format}'
    source.write_bytes(WRITERS[in_format](mesh))
    listed = run(program, 'encode', source, stream, '--lossless', '--keep-order', '--keep-unreferenced', '--json')
    listed += run(program, 'decode', stream, target, '--json')
    names = {entry['name'] for entry in listed}
    before, after = mesh, READERS[out_format](target.read_bytes())
    if {in_format, out_format} & {'gltf', 'glb'}:
        before = in_order_of_groups(before)
    assert len(before['faces']) == len(after['faces'])
    failures = []
    for key in [k for k in mesh if k not in ('faces', 'properties')] + list(mesh.get('properties', {})):
        # Doubles become float32 beside an origin; text has the shortest digits of a float32; glTF has 16 bits of linear light.
        tolerance = {'points': 3e-7 if mesh['points'].dtype == np.float64 else 0, 'colors': 0.03, 'normals': 1e-6}.get(key, 0)
        if same(key, corners(before, key), corners(after, key), tolerance):
            continue
        if not NAMES.get(key, {key, '_' + key}) & names:
            failures.append((in_format, number, out_format, key, sorted(names)))
    return failures


def main(program):
    failures = []
    with tempfile.TemporaryDirectory() as folder:
        for in_format in WRITERS:
            for out_format in READERS:
                for number in range(5):
                    failures += check(program, Path(folder), in_format, number, out_format)
    for failure in failures:
        print('neither the same nor told:', *failure)
    print(f'{36 * 5 - len({f[:3] for f in failures})} of {36 * 5} round trips are complete')
    return 1 if failures else 0


if __name__ == '__main__':
    sys.exit(main(sys.argv[1]))
