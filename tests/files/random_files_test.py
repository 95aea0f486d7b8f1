"""random_files_test.py READ_MANY FORMAT FILES: small files from a seed, half of them damaged a little; the library and
plain_readers.py must find the same mesh in them, or both refuse."""
import math
import random
import struct
import subprocess
import sys

import plain_readers
import plain_text

NUMBERS = ('0', '1', '-1', '0.5', '.25', '2.', '1e1', '-2.5E-1', '+3', '7', '0.125')
JUNK = ('-1.#IND', '1,5', '1e', 'x', '1e999', '--1', '+-1', '1/', '#', '# c', '\\', '/', '0x10', 'nan', 'inf', '-0', '1.5', '3', '99', '-7',
        '2//1', '1//', 'v', 'f', 'facet', 'solid', 'endsolid', 'vertex', 'OFF', '0', '1e-999', '256', '-129')
BYTES = ('\0', '\t', ' ', '\r', '\n', '\r\n', '\\\n', '\\\r\n', '\xff', '#', '-', '.', 'e', '1')


def point(r):
    return ' '.join(r.choice(NUMBERS) for _ in range(3))


def convex(r, vertices):
    """Corners of a face: three, or with equal ones, as what a fan fills is not the matter here."""
    return [r.randrange(vertices) for _ in range(3)] if r.random() < 0.9 else [r.randrange(vertices) for _ in range(r.choice((1, 2)))]


def make_obj(r):
    lines, counts = [], [0, 0, 0]
    for _ in range(r.randint(3, 7)):
        extra = r.choice(('', '', '', ' 1', ' 1 0 0.5', ' 1 0 0 1'))
        lines.append('v ' + point(r) + extra)
    vertices = len(lines)
    for kind in range(2):
        for _ in range(r.randint(0, 2)):
            lines.append(('vt 0 1', 'vn 0 0 1')[kind])
            counts[kind] += 1
    for _ in range(r.randint(0, 4)):
        form = r.choice(('{0}', '{0}/', '{0}//', '{0}/{1}', '{0}//{2}', '{0}/{1}/{2}'))
        if ('{1}' in form and not counts[0]) or ('{2}' in form and not counts[1]):
            form = '{0}'
        corners = [form.format(i + 1 if r.random() < 0.7 else i - vertices, r.randint(1, max(counts[0], 1)), r.randint(1, max(counts[1], 1)))
                   for i in convex(r, vertices)]
        lines.append('f ' + ' '.join(corners))
        if r.random() < 0.3:
            lines.append(r.choice(('g a b', 'usemtl m#1', 's 1', 'l 1 2', 'o', '# c', '', 'mtllib x', 'vp 1')))
    return lines


def make_off(r):
    vertices, faces = r.randint(3, 6), r.randint(0, 4)
    prefix = r.choice(('', '', 'C', 'N', 'ST', 'CN'))
    head = f'{vertices} {faces}' + r.choice(('', ' 0', ' 5'))
    lines = [prefix + 'OFF' + r.choice(('\n', ' ', '')) + head]
    extra = ' 0 0 1' * ('N' in prefix) + ' 1 2 3' * ('C' in prefix) + ' 0 1' * ('ST' in prefix)
    lines += [point(r) + extra for _ in range(vertices)]
    for _ in range(faces):
        corners = convex(r, vertices)
        lines.append(' '.join(map(str, [len(corners)] + corners)) + r.choice(('', '', ' 255 0 0', ' 1 0.5 0 1', ' 4')))
    return lines


def make_ply(r):
    vertices, faces = r.randint(3, 6), r.randint(0, 4)
    types = ('float', 'double', 'float32')
    lines = ['ply', 'format ascii 1.0', f'element vertex {vertices}']
    lines += [f'property {r.choice(types)} {axis}' for axis in 'xyz']
    more = r.random() < 0.3
    lines += ['property uchar quality'] * more
    lines += [f'element face {faces}', r.choice(('property list uchar int vertex_indices', 'property list int uint vertex_index'))]
    flags = r.random() < 0.3
    lines += ['property char flags'] * flags + ['end_header']
    lines += [point(r) + ' 200' * more for _ in range(vertices)]
    for _ in range(faces):
        corners = convex(r, vertices)
        lines.append(' '.join(map(str, [len(corners)] + corners)) + ' -5' * flags)
    return lines


def make_stl(r):
    lines = ['solid' + r.choice(('', ' name', ' two words'))]
    for _ in range(r.randint(1, 4)):
        lines += ['facet normal 0 0 1', 'outer loop'] + ['vertex ' + point(r) for _ in range(3)] + ['endloop', 'endfacet']
    lines += r.choice(([], ['endsolid'], ['endsolid name']))
    return lines if r.random() < 0.7 else [lines[0], ' '.join(lines[1:])]


def damage(r, text):
    at = r.randrange(len(text) + 1)
    what = r.randrange(6)
    if what == 0:
        return text[:at] + r.choice(BYTES) + text[at:]
    if what == 1:
        return text[:at] + text[at + r.randint(1, 3):]
    if what == 2:
        return text[:at]
    words = text.split(' ')
    word = r.randrange(len(words))
    if what == 3:
        words[word] = r.choice(JUNK)
    elif what == 4:
        words.insert(word, r.choice(JUNK))
    else:
        words[word] = words[word] + r.choice(JUNK)
    return ' '.join(words)


def make(r, file_format):
    lines = globals()['make_' + file_format](r)
    end = r.choice(('\n', '\n', '\r\n', '\r', ' \n'))
    text = r.choice(('', '', '', '\xef\xbb\xbf')) + end.join(lines) + r.choice(('', end, end + '\0\0'))
    for _ in range(r.choice((0, 0, 1, 1, 2))):
        text = damage(r, text)
    return text.encode('latin-1')


def same(a, b):
    return a == b or abs(a - b) <= 1e-6 * max(abs(a), abs(b)) or (math.isnan(a) and math.isnan(b))


def agrees(line, expected):
    if line.startswith('refused') or expected is None:
        return line.startswith('refused') and expected is None
    values = line.split()
    points, triangles, exact = expected
    if [int(values[0]), int(values[1])] != [len(points), len(triangles)]:
        return False
    split = 2 + 3 * len(points)
    return (all(same(float(a), b) for a, b in zip(values[2:split], (x for p in points for x in p))) and
            (not exact or list(map(int, values[split:])) == [i for t in triangles for i in t]))


def main():
    program, file_format, files = sys.argv[1], sys.argv[2], int(sys.argv[3])
    r = random.Random(file_format)
    inputs = [make(r, file_format) for _ in range(files)]
    packed = b''.join(struct.pack('<I', len(data)) + data for data in inputs)
    lines = subprocess.run([program, file_format], input=packed, capture_output=True, check=True).stdout.decode().splitlines()
    wrong, refused = 0, 0
    for data, line in zip(inputs, lines, strict=True):
        try:
            expected = plain_readers.read(file_format, data)
        except plain_text.Refused:
            expected = None
            refused += 1
        if not agrees(line, expected):
            wrong += 1
            if wrong <= 5:
                print(f'{data!r}\n  library: {line}\n  plain:   {expected}')
    print(f'{files} files, {refused} refused, {wrong} differ')
    sys.exit(wrong > 0 or not files // 10 < refused < files * 9 // 10)


main()
