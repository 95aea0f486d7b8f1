// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { creasedNormals, hasCreases, withCopies, withoutCopies } from '../src/mesh/creases.js';
import { displayOf, frameOf } from '../src/mesh/display.js';
import { uniqueEdges } from '../src/mesh/edges.js';
import { knot } from '../src/mesh/shapes.js';

const box = {
  positions: new Float32Array([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1]),
  indices: new Uint32Array([0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4, 1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6, 3, 0, 4, 3, 4, 7]),
  attributes: [],
};
const mesh = { groups: null, ...box };

/** A drum: its side is round, its ends are flat. */
function drum(sides) {
  const positions = [0, 0, 0, 0, 0, 1];
  for (let i = 0; i < sides; ++i) for (const z of [0, 1]) positions.push(Math.cos((2 * Math.PI * i) / sides), Math.sin((2 * Math.PI * i) / sides), z);
  const indices = [];
  for (let i = 0; i < sides; ++i) {
    const [a, b] = [2 + 2 * i, 2 + 2 * ((i + 1) % sides)];
    indices.push(0, b, a, 1, a + 1, b + 1, a, b, b + 1, a, b + 1, a + 1);
  }
  return { positions: new Float32Array(positions), indices: new Uint32Array(indices) };
}

test('a box has a normal for each of its sides at each corner', () => {
  assert.ok(hasCreases(box.positions, box.indices));
  const { normals, indices, copies } = creasedNormals(box.positions, box.indices);
  assert.equal(copies.length, 16);
  const all = withCopies(box.positions, 3, copies);
  for (let i = 0; i < indices.length; i += 3) {
    const [a, b, c] = [0, 1, 2].map((corner) => Array.from(normals.subarray(3 * indices[i + corner], 3 * indices[i + corner] + 3)));
    assert.deepEqual(a, b);
    assert.deepEqual(b, c);
    assert.equal(Math.hypot(...a), 1);
    for (let corner = 0; corner < 3; ++corner) {
      const at = (index, values) => Array.from(values.subarray(3 * index, 3 * index + 3));
      assert.deepEqual(at(indices[i + corner], all), at(box.indices[i + corner], box.positions));
    }
  }
});

test('edges of a box come once, whatever its vertices are split into', () => {
  const { indices, copies } = creasedNormals(box.positions, box.indices);
  const count = 8 + copies.length;
  assert.equal(uniqueEdges(indices, count, withoutCopies(count, copies)).length, 2 * 18);
});

test('what is round stays smooth beside what is flat', () => {
  const { positions, indices } = drum(48);
  assert.ok(hasCreases(positions, indices));
  const { normals, copies } = creasedNormals(positions, indices);
  assert.equal(copies.length, 96, 'each vertex of the rims twice');
  for (let at = 0; at < normals.length; at += 3) assert.ok(Math.abs(normals[at + 2]) < 1e-6 || Math.abs(normals[at + 2]) > 1 - 1e-6);
});

test('what nobody designed is smooth, and so is a vertex of very many faces', () => {
  const { positions, indices } = knot(120, 24);
  assert.ok(!hasCreases(positions, indices));
  const cone = drum(1000);
  assert.equal(creasedNormals(cone.positions, cone.indices).copies.length, 2000);
});

test('a display has copies of all that its vertices have, but where a mesh has normals', () => {
  const frame = frameOf(mesh);
  assert.ok(frame.isCreased);
  const colors = { kind: 'color', name: 'color', components: 3, normalized: true, values: new Uint8Array(24).fill(255) };
  const display = displayOf({ ...mesh, attributes: [colors] }, frame);
  assert.deepEqual([display.positions.length, display.normals.length, display.colors.length, display.copies.length], [72, 72, 96, 16]);
  const normal = { kind: 'normal', name: 'n', components: 3, normalized: false, values: new Float32Array(24).fill(1) };
  assert.ok(!frameOf({ ...mesh, attributes: [normal] }).isCreased);
  assert.equal(displayOf(mesh, { ...frame, isCreased: false }).positions.length, 24);
});
