"""asset_borders_test.py PROGRAM CORPUS: positions that are bit-equal in several primitives of an asset, under equal transforms, are so in the
packed and unpacked asset: no position is torn, at ten settings."""
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


def main(program, corpus):
    assets = sorted(Path(corpus).glob('gltf/*.glb')) if corpus else []
    if not assets:
        print('skipped: no corpus')
        return 77
    total = failures = 0
    with tempfile.TemporaryDirectory() as folder:
        packed, plain = Path(folder) / 'packed.glb', Path(folder) / 'plain.glb'
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
                total, failures = total + common, failures + apart
                if apart:
                    print(asset.name, *setting, f'{apart} of {common} torn')
    print(f'{failures} of {total} positions torn')
    return 1 if failures else 0


if __name__ == '__main__':
    sys.exit(main(sys.argv[1], os.environ.get('DELTAMESH_CORPUS') or (sys.argv[2] if os.path.isdir(sys.argv[2]) else '')))
