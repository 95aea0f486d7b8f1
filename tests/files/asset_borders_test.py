"""asset_borders_test.py PROGRAM CORPUS: positions that are bit-equal in several primitives of an asset, under equal transforms, are so in the
packed and unpacked asset: no position is torn, at ten settings. Assets: generated scenes cut into 2, 9 and 100 meshes, also below nodes that turn
and scale all of them, and those of the corpus, where there is one."""
import json
import os
import struct
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

SETTINGS = ([], ['--max-error', '0.1%'], ['--max-error', '0.005%'], ['--lfe', '0.05%'], ['--vde', '0.05%'], ['--geometry', 'highpass', '--bits', '9'],
            ['--geometry', 'predictive', '--bits', '12'], ['--lossless'], ['--geometry', 'highpass', '--max-error', '0.05%'],
            ['--geometry', 'predictive', '--max-error', '0.5%'])


def matrix(node):
    if 'matrix' in node:
        return np.array(node['matrix']).reshape(4, 4).T
    x, y, z, w = node.get('rotation', (0, 0, 0, 1))
    turn = np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)], [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                     [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]])
    result = np.eye(4)
    result[:3, :3], result[:3, 3] = turn * np.array(node.get('scale', (1, 1, 1))), node.get('translation', (0, 0, 0))
    return result


def places(document):
    """Of every mesh the transforms under which it is seen, as bytes."""
    result = {}
    nodes = document.get('nodes', [])
    children = {c for node in nodes for c in node.get('children', [])}
    pending = [(i, np.eye(4)) for i in range(len(nodes)) if i not in children]
    while pending:
        number, above = pending.pop()
        here = above if 'skin' in nodes[number] else above @ matrix(nodes[number])
        if 'mesh' in nodes[number]:
            result.setdefault(nodes[number]['mesh'], set()).add(here.tobytes())
        pending += [(c, here) for c in nodes[number].get('children', [])]
    return result


def positions(data):
    """A list of (transforms, primitive's name, rows of bytes at all corners)."""
    size = struct.unpack('<I', data[12:16])[0]
    document, blob = json.loads(data[20:20 + size]), data[28 + size:]
    seen, result = places(document), []
    for m, mesh in enumerate(document['meshes']):
        for p, primitive in enumerate(mesh['primitives']):
            a = document['accessors'][primitive['attributes']['POSITION']]
            if a['componentType'] != 5126 or 'bufferView' not in a or 'sparse' in a or 'indices' not in primitive or primitive.get('mode', 4) != 4:
                continue

            def rows(accessor, size):
                view = document['bufferViews'][accessor['bufferView']]
                start, stride = view.get('byteOffset', 0) + accessor.get('byteOffset', 0), view.get('byteStride', size)
                return [blob[start + i * stride:start + i * stride + size] for i in range(accessor['count'])]

            index = document['accessors'][primitive['indices']]
            points = rows(a, 12)
            corners = [int.from_bytes(i, 'little') for i in rows(index, {5121: 1, 5123: 2, 5125: 4}[index['componentType']])]
            result.append((frozenset(seen.get(m, ())), (m, p), [points[i] for i in corners]))
    return result


def torn(before, after):
    """Of how many positions in common; how many of them are apart."""
    owners = {}
    for (where, name, rows), (_, _, decoded) in zip(before, after):
        assert len(rows) == len(decoded)
        for row, now in zip(rows, decoded):
            owners.setdefault((where, row), {}).setdefault(name, set()).add(now)
    common = [frozenset().union(*own.values()) for own in owners.values() if len(own) > 1]
    return len(common), sum(len(now) > 1 for now in common)


def scene(chunks, node):
    """A wavy sheet of chunks x chunks meshes, each with its own accessors, as a GLB; all below `node`."""
    size = max(48 // chunks, 6)
    blob, views, accessors, meshes = b'', [], [], []
    for number in range(chunks * chunks):
        i, j = np.meshgrid(np.arange(size + 1) + number // chunks * size, np.arange(size + 1) + number % chunks * size, indexing='ij')
        points = np.stack([i * 0.37, j * 0.41, np.sin(i / 3) * np.cos(j / 4)], -1).reshape(-1, 3).astype('<f4')
        k = (np.arange(size)[:, None] * (size + 1) + np.arange(size)).ravel()
        corners = np.concatenate([np.stack([k, k + size + 1, k + 1], 1), np.stack([k + 1, k + size + 1, k + size + 2], 1)]).astype('<u2')
        for array, kind in ((points, {'componentType': 5126, 'count': len(points), 'type': 'VEC3', 'min': points.min(0).tolist(), 'max': points.max(0).tolist()}),
                            (corners, {'componentType': 5123, 'count': corners.size, 'type': 'SCALAR'})):
            accessors.append({'bufferView': len(views), **kind})
            views.append({'buffer': 0, 'byteOffset': len(blob), 'byteLength': array.nbytes})
            blob += array.tobytes() + bytes(-array.nbytes % 4)
        meshes.append({'primitives': [{'attributes': {'POSITION': 2 * number}, 'indices': 2 * number + 1}]})
    nodes = [{**node, 'children': list(range(1, len(meshes) + 1))}] + [{'mesh': m} for m in range(len(meshes))]
    text = json.dumps({'asset': {'version': '2.0'}, 'accessors': accessors, 'bufferViews': views, 'buffers': [{'byteLength': len(blob)}], 'meshes': meshes,
                       'nodes': nodes, 'scenes': [{'nodes': [0]}], 'scene': 0}).encode()
    text += b' ' * (-len(text) % 4)
    return struct.pack('<4sIIII', b'glTF', 2, 28 + len(text) + len(blob), len(text), 0x4e4f534a) + text + struct.pack('<II', len(blob), 0x4e4942) + blob


def two_meshes():
    """The scene of four, of which two are left out."""
    data = scene(2, {})
    size = struct.unpack('<I', data[12:16])[0]
    document = json.loads(data[20:20 + size])
    document['nodes'][0]['children'] = [1, 2]
    document['meshes'] = document['meshes'][:2]
    document['nodes'] = document['nodes'][:3]
    text = json.dumps(document).encode()
    text += b' ' * (-len(text) % 4)
    return struct.pack('<4sIIII', b'glTF', 2, 20 + len(text) + len(data) - 20 - size, len(text), 0x4e4f534a) + text + data[20 + size:]


def generated(folder):
    turned = {'rotation': [0.5, 0.5, 0.5, 0.5], 'scale': [2, 3, 0.5], 'translation': [1e3, 0, 0]}
    scenes = {'two': two_meshes(), 'nine': scene(3, {}), 'nine_turned': scene(3, turned), 'hundred': scene(10, turned)}
    for name, data in scenes.items():
        (folder / f'{name}.glb').write_bytes(data)
    return [folder / f'{name}.glb' for name in scenes]


def main(program, corpus):
    total = failures = 0
    with tempfile.TemporaryDirectory() as folder:
        packed, plain = Path(folder) / 'packed.glb', Path(folder) / 'plain.glb'
        assets = generated(Path(folder)) + (sorted(Path(corpus).glob('gltf/*.glb')) if corpus else [])
        for asset in assets:
            before = positions(asset.read_bytes())
            for setting in SETTINGS:
                arguments = ['gltf', 'pack', str(asset), str(packed), '--keep-order', '--keep-unreferenced', '--effort', '0', *setting]
                done = subprocess.run([program, *arguments], capture_output=True, text=True)
                if done.returncode:
                    print(asset.name, *setting, done.stderr.strip())
                    continue
                subprocess.run([program, 'gltf', 'unpack', str(packed), str(plain)], check=True, capture_output=True)
                common, apart = torn(before, positions(plain.read_bytes()))
                assert common > 0 or asset.parent != Path(folder), f'{asset.name}: no border'
                total, failures = total + common, failures + apart
                if apart:
                    print(asset.name, *setting, f'{apart} of {common} torn')
    print(f'{failures} of {total} positions torn')
    return 1 if failures else 0


if __name__ == '__main__':
    sys.exit(main(sys.argv[1], os.environ.get('DELTAMESH_CORPUS') or (sys.argv[2] if os.path.isdir(sys.argv[2]) else '')))
