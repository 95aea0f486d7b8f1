// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Scenes become one mesh, with what finds its vertices again.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { readMesh } from '../src/mesh/read-mesh.js';
import { writeGlb } from '../src/mesh/write-glb.js';

const read = (mesh) => readMesh(new File([writeGlb({ origin: [0, 0, 0], groups: null, attributes: [], ...mesh })], 'mesh.glb'), { modules: {} });

test('positions of whole numbers are moved to places between them', async () => {
  const positions = new Int16Array([0, 0, 0, 3, 0, 0, 0, 5, 0]);
  const { mesh, up, isGlb } = await read({ positions, indices: new Uint32Array([0, 1, 2]), origin: [0.25, 0, 0] });
  assert.deepEqual([...mesh.positions], [0.25, 0, 0, 3.25, 0, 0, 0.25, 5, 0]);
  assert.deepEqual([up, isGlb], ['y', true]);
});

test('every mesh of a scene has its place in the one that is read', async () => {
  const positions = new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0]);
  const indices = new Uint32Array([0, 1, 2, 2, 1, 3]);
  const { mesh, places } = await read({ positions, indices, groups: new Uint32Array([0, 1]) });
  assert.deepEqual(places, [{ start: 0, corners: null }, { start: 4, corners: null }]);
  assert.equal(mesh.positions.length, 24);
  assert.deepEqual([...mesh.groups], [0, 1]);
});
