// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { test } from 'node:test';

import { DeltameshError, createDecoder } from '@deltamesh/decoder';
import { DeltameshLoader, gltfDeltameshExtension } from '@deltamesh/three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';

// What three.js uses of browsers and node does not have.
globalThis.ProgressEvent ??= class ProgressEvent extends Event {};

const root = new URL('../../../../', import.meta.url);
const samples = new URL('gltf_ext/DELTAMESH_mesh_compression/samples/', root);
const golden = (name) => {
  const folder = new URL('tests/golden/', root);
  const file = readdirSync(folder).find((other) => other.startsWith(`${name}.`) && other.endsWith('.dmsh'));
  return new Uint8Array(readFileSync(new URL(file, folder))).buffer;
};

async function loadGltf(url) {
  const loader = new GLTFLoader().register(gltfDeltameshExtension(new DeltameshLoader()));
  const bytes = new Uint8Array(readFileSync(url));
  return loader.parseAsync(bytes.buffer, '');
}

function meshesOf({ scene }) {
  const meshes = [];
  scene.traverse((object) => object.isMesh && meshes.push(object));
  return meshes;
}

test('a stream becomes a geometry with attributes, groups and quality', async () => {
  const geometry = await new DeltameshLoader().parseAsync(golden('asset.bounded'));
  const mesh = await (await createDecoder()).decode(new Uint8Array(golden('asset.bounded')));
  assert.deepEqual(
    ['position', 'normal', 'tangent', 'uv', 'color', 'skinIndex', 'skinWeight'].filter((name) => !geometry.attributes[name]),
    [],
  );
  assert.equal(geometry.attributes.color.normalized, true);
  assert.deepEqual(geometry.attributes.position.array, mesh.positions);
  assert.deepEqual(geometry.userData.deltamesh.quality, mesh.quality);
  assert.equal(geometry.groups.length, new Set(mesh.groups).size);
  for (const { start, count, materialIndex } of geometry.groups) {
    const faces = [...mesh.groups.keys()].filter((face) => mesh.groups[face] === materialIndex);
    assert.deepEqual(
      [...geometry.index.array.slice(start, start + count)],
      faces.flatMap((face) => [...mesh.indices.slice(3 * face, 3 * face + 3)]),
    );
  }
});

test('a bad stream is a DeltameshError', async () => {
  await assert.rejects(new DeltameshLoader().parseAsync(new ArrayBuffer(100)), DeltameshError);
});

test('an aborted signal rejects', async () => {
  const signal = AbortSignal.abort();
  await assert.rejects(new DeltameshLoader().parseAsync(golden('grid.bits6'), { signal }), { name: 'AbortError' });
});

for (const name of ['cube.glb', 'cube.gltf', 'cube_fallback.glb', 'two_materials.gltf']) {
  test(`GLTFLoader reads ${name}`, async () => {
    const meshes = meshesOf(await loadGltf(new URL(`valid/${name}`, samples)));
    assert.ok(meshes.length > 0);
    for (const { geometry } of meshes) {
      assert.ok(geometry.attributes.position.count > 0);
      assert.ok(geometry.index.count > 0);
      assert.ok(geometry.index.array.every((index) => index < geometry.attributes.position.count));
    }
  });
}

test('GLTFLoader sees the data that fallback accessors have', async () => {
  const url = new URL('valid/cube_fallback.glb', samples);
  const [decoded] = meshesOf(await loadGltf(url));
  const bytes = new Uint8Array(readFileSync(url));
  const [plain] = meshesOf(await new GLTFLoader().parseAsync(bytes.buffer, ''));
  for (const [name, { array }] of Object.entries(plain.geometry.attributes))
    assert.deepEqual(decoded.geometry.attributes[name].array, array, name);
  assert.deepEqual(decoded.geometry.index.array, plain.geometry.index.array);
});

for (const name of readdirSync(new URL('invalid/', samples))) {
  test(`GLTFLoader refuses ${name} by its rule`, async () => {
    await assert.rejects(loadGltf(new URL(`invalid/${name}`, samples)), (error) => {
      assert.ok(error instanceof DeltameshError, String(error));
      assert.equal(error.rule, name.split('_')[0]);
      return true;
    });
  });
}
