"""small_files_test.py READ_MANY: files of at most 1 KB that state much more than they hold, and damaged small ones: reading one takes at most
10 MB and 1 s, whatever it says."""
import json
import random
import struct
import subprocess
import sys
import tempfile

MOST_BYTES, MOST_SECONDS = 10 << 20, 1.0
MEASURED = '''
import resource, subprocess, sys
subprocess.run(sys.argv[1:3], stdin=open(sys.argv[3], 'rb'), stdout=subprocess.DEVNULL)
used = resource.getrusage(resource.RUSAGE_CHILDREN)
print(used.ru_utime + used.ru_stime)
'''


def gltf(count, attributes=('POSITION',), nodes=None, **more):
    kinds = {'POSITION': 'VEC3', 'NORMAL': 'VEC3', 'TANGENT': 'VEC4'}
    accessors = [{'componentType': 5126, 'count': count, 'type': kinds.get(name, 'VEC4')} for name in attributes]
    mesh = {'primitives': [{'attributes': {name: i for i, name in enumerate(attributes)}}]}
    return json.dumps({'asset': {'version': '2.0'}, 'accessors': accessors, 'meshes': [mesh], 'nodes': nodes or [{'mesh': 0}], **more}).encode()


def liars():
    for count in (1 << 15, 1 << 20, 1 << 31, 1 << 40):
        yield 'gltf', gltf(count)
        yield 'gltf', gltf(count, ['POSITION', 'NORMAL', 'TANGENT', '_A', '_B', '_C', '_D', '_E'])
        yield 'gltf', gltf(count // 40, nodes=[{'mesh': 0}] * 40)
        yield 'off', b'OFF %d %d 0\n0 0 0\n' % (count, count)
        yield 'stl', bytes(80) + struct.pack('<I', min(count, 2 ** 32 - 1)) + bytes(50)
        for form in (b'ascii', b'binary_little_endian'):
            yield 'ply', (b'ply\nformat %s 1.0\nelement vertex %d\nproperty float x\nproperty float y\nproperty float z\nelement face %d\n'
                          b'property list uint int vertex_indices\nend_header\n' % (form, count, count)) + b'\xff' * 100
        yield 'ply', b'ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement nothing %d\nend_header\n' % count
        yield 'obj', b'v 0 0 0\nf %d 1 1\n' % count
    yield 'gltf', b'[' * 1000
    yield 'gltf', b'{"a":' * 200
    yield 'obj', b'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 1\nf' + b' 1 3 2 4' * 120 + b'\n'
    yield 'off', b'OFF 4 1 0\n0 0 0\n1 0 0\n0 1 0\n1 1 1\n450' + b' 0 2 1 3' * 112 + b' 0 1\n'
    yield 'obj', b'v 0 0 0\\\n' * 100 + b'o x\n' * 20


def damaged(r, data):
    data = bytearray(data[:1024])
    for _ in range(r.randint(1, 4)):
        data[r.randrange(len(data))] = r.randrange(256)
    return bytes(data)


def measure(program, file_format, data):
    with tempfile.NamedTemporaryFile() as file:
        file.write(struct.pack('<I', len(data)) + data)
        file.flush()
        done = subprocess.run([sys.executable, '-c', MEASURED, program, file_format, file.name], capture_output=True, text=True, check=True)
    return int(done.stderr.split()[1]) * 1024, float(done.stdout)


def main(program):
    r = random.Random(1)
    files = [(kind, data[:1024]) for kind, data in liars()]
    files += [(kind, damaged(r, data)) for kind, data in files for _ in range(3)]
    base, _ = measure(program, 'obj', b'')
    worst, slowest, failures = 0, 0.0, 0
    for file_format, data in files:
        size, seconds = measure(program, file_format, data)
        worst, slowest = max(worst, size - base), max(slowest, seconds)
        if size - base > MOST_BYTES or seconds > MOST_SECONDS:
            print(file_format, size - base, seconds, data[:200])
            failures += 1
    print(f'{len(files)} files, at most {worst} bytes and {slowest:.2f} s')
    return 1 if failures else 0


if __name__ == '__main__':
    sys.exit(main(sys.argv[1]))
