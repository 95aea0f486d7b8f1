// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Meshes: welding, edges, errors, GLB.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { frameOf } from '../src/mesh/display.js';
import { uniqueEdges } from '../src/mesh/edges.js';
import { EXAMPLES, makeExample } from '../src/mesh/examples.js';
import { sizeAt } from '../src/peers/at-error.js';
import { packOrder, unpackOrder } from '../src/mesh/prepared.js';
import { vertexErrors } from '../src/mesh/vertex-errors.js';
import { weld } from '../src/mesh/weld.js';
import { writeGlb } from '../src/mesh/write-glb.js';
import { fewestBits, latticeError, levelsOf, octahedronError } from '../src/peers/quantize.js';

const square = {
  origin: [0, 0, 0],
  positions: new Float32Array([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0]),
  indices: new Uint32Array([0, 1, 2, 0, 2, 3]),
  groups: null,
  attributes: [],
};

test('equal rows become one vertex, in the order they come', () => {
  const values = new Float32Array([1, 2, 3, 4, 1, 2, 1, 3]);
  const { rows, numbers } = weld([{ values, components: 2 }], 4);
  assert.deepEqual([...rows], [0, 1, 3]);
  assert.deepEqual([...numbers], [0, 1, 0, 2]);
});

test('every edge comes once', () => {
  const edges = uniqueEdges(square.indices, 4);
  const pairs = Array.from({ length: edges.length / 2 }, (_, i) => `${edges[2 * i]} ${edges[2 * i + 1]}`);
  assert.deepEqual(pairs.sort(), ['0 1', '0 2', '0 3', '1 2', '2 3']);
});

test('examples have vertices that faces use, and finite coordinates', () => {
  for (const name of Object.keys(EXAMPLES)) {
    const { positions, indices } = makeExample(name).mesh;
    assert.ok(positions.every(Number.isFinite), name);
    assert.equal(new Set(indices).size, positions.length / 3, name);
  }
});

test('a lifted vertex is above the original, and neighbours feel it in VDE', () => {
  const positions = square.positions.slice();
  positions[8] = 0.1;
  const { signed, vde, normal } = vertexErrors(square, { ...square, positions }, new Uint32Array([0, 1, 2, 3]));
  assert.deepEqual([...signed].map((value) => value.toFixed(3)), ['0.000', '0.000', '0.100', '0.000']);
  assert.ok(vde[2] > 0.09 && vde[1] > 0 && vde[0] > 0);
  assert.ok(normal.every((angle) => angle > 0 && angle < 20));
});

test('errors of colours are 255ths, in the order of decoded vertices', () => {
  const colored = (values) => ({ ...square, attributes: [{ kind: 'color', name: 'color', components: 3, normalized: true, values }] });
  const source = colored(new Uint8Array([0, 0, 0, 10, 10, 10, 20, 20, 20, 30, 30, 30]));
  const order = new Uint32Array([1, 0, 3, 2]);
  const { tint } = vertexErrors(source, colored(new Uint8Array([10, 10, 10, 0, 0, 0, 30, 30, 36, 23, 20, 20])), order);
  assert.deepEqual([...tint].map((value) => value.toFixed(3)), ['0.000', '0.000', '3.464', '1.732']);
  assert.ok(vertexErrors(square, square, order).tint.every((value) => value === 0));
});

test('errors follow the order of decoded vertices', () => {
  const decoded = { ...square, positions: new Float32Array([1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0]), indices: new Uint32Array([1, 2, 0, 1, 0, 3]) };
  const { signed, vde } = vertexErrors(square, decoded, new Uint32Array([2, 0, 1, 3]));
  assert.ok([...signed, ...vde].every((value) => value === 0));
});

test('a lattice of few steps has the error that was measured', () => {
  assert.equal(latticeError(square.positions, { min: [0, 0, 0], side: 1 }, 1), 0);
  const error = latticeError(new Float32Array([0.25, 0, 0]), { min: [0, 0, 0], side: 1 }, 2);
  assert.ok(Math.abs(error - 0.25) < 1e-12);
});

test('normals on an octahedron are nearer with every bit', () => {
  const normals = new Float32Array([1, 0, 0, 0.6, 0, -0.8, 0.36, 0.48, 0.8, -0.48, 0.6, 0.64]);
  const errors = [4, 8, 12].map((bits) => octahedronError(normals, bits));
  assert.ok(errors[0] > errors[1] && errors[1] > errors[2] && errors[2] < 0.05, errors.join());
  assert.equal(fewestBits((bits) => 2 ** -bits, 0.1, 1, 30), 4);
});

test('levels of bytes are as far apart as the error allows', () => {
  assert.deepEqual([...levelsOf(new Uint8Array([0, 1, 2, 4, 255]), 1)], [0, 0, 1, 1, 85]);
  assert.deepEqual([...levelsOf(new Uint8Array([0, 7, 255]), 0)], [0, 7, 255]);
});

test('GLB has rows at multiples of four bytes and a primitive for each group', () => {
  const values = new Uint8Array([1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12]);
  const attributes = [{ kind: 'color', name: 'color', components: 3, normalized: true, values }];
  const glb = writeGlb({ ...square, groups: new Uint32Array([0, 5]), attributes });
  const view = new DataView(glb.buffer);
  assert.equal(view.getUint32(8, true), glb.length);
  const json = JSON.parse(new TextDecoder().decode(glb.subarray(20, 20 + view.getUint32(12, true))));
  assert.equal(json.meshes[0].primitives.length, 2);
  const color = json.accessors[json.meshes[0].primitives[0].attributes.COLOR_0];
  // As linear light, in 16 bits.
  assert.equal(color.componentType, 5123);
  const { byteStride, byteOffset } = json.bufferViews[color.bufferView];
  assert.equal(byteStride, 8);
  assert.equal(view.getUint16(28 + view.getUint32(12, true) + byteOffset, true), Math.round(65535 / 255 / 12.92));
  assert.deepEqual(json.accessors[0].max, [1, 1, 0]);
});

test('the frame is that of the bounding box', () => {
  assert.deepEqual(frameOf({ attributes: [], ...square }), { center: [0.5, 0.5, 0], diagonal: Math.SQRT2, isCreased: false });
});

test('a size at an error lies on the line between two points, or is the nearest', () => {
  const points = [{ error: 4, bytes: 100 }, { error: 1, bytes: 400 }];
  assert.equal(sizeAt(points, 4), 100);
  assert.equal(sizeAt(points, 2), 200);
  assert.equal(sizeAt(points, 1), 400);
  assert.equal(sizeAt(points, 9), 100);
  assert.equal(sizeAt(points, 0.5), 400);
});

test('an order is packed and unpacked', () => {
  const order = Uint32Array.from([5, 0, 4294967295, 7]);
  assert.deepEqual(unpackOrder(packOrder(order)), order);
});
