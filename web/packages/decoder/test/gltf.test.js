// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { arrayOf } from '../gltf.js';

const indicesOf = (mesh, group, count, componentType = 5125) =>
  arrayOf(mesh, { kind: 'indices', group, source: 'here' }, { type: 'SCALAR', componentType, count });

const meshOf = (groups) => ({
  origin: [0, 0, 0],
  indices: new Uint32Array(3 * groups.length).map((_, corner) => corner),
  groups: new Uint32Array(groups),
});

test('every group has its triangles, in their order', () => {
  const mesh = meshOf([2, 0, 2, 5, 0]);
  for (let round = 0; round < 2; ++round) {
    assert.deepEqual([...indicesOf(mesh, 0, 6)], [3, 4, 5, 12, 13, 14]);
    assert.deepEqual([...indicesOf(mesh, 2, 6)], [0, 1, 2, 6, 7, 8]);
    assert.deepEqual(indicesOf(mesh, 5, 3, 5123), new Uint16Array([9, 10, 11]));
  }
  assert.deepEqual([...indicesOf(meshOf([2]), 2, 3)], [0, 1, 2]);
});

test('a group without triangles is an error', () => {
  for (const group of [1, 6, 2 ** 32, -1, 0.5, '2', 'length', null])
    assert.throws(() => indicesOf(meshOf([2, 0, 2, 5, 0]), group, 3), { rule: 'GLTF-11' }, String(group));
  assert.throws(() => indicesOf({ ...meshOf([0]), groups: null }, 1, 3), { rule: 'GLTF-11' });
});

test('an asset of thousands of groups does not read all faces for each', () => {
  const groups = 20000;
  const mesh = meshOf(Array.from({ length: 20 * groups }, (_, face) => face % groups));
  for (let group = 0; group < groups; ++group) assert.equal(indicesOf(mesh, group, 60)[0], 3 * group);
});
