// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { test } from 'node:test';

import { NullEngine } from '@babylonjs/core/Engines/nullEngine.js';
import { ImportMeshAsync } from '@babylonjs/core/Loading/sceneLoader.js';
import { Logger } from '@babylonjs/core/Misc/logger.js';
import { Scene } from '@babylonjs/core/scene.js';
import '@babylonjs/loaders/glTF/2.0/index.js';
import { registerDeltamesh } from '@deltamesh/babylon';

Logger.LogLevels = Logger.NoneLogLevel;
const samples = new URL('../../../../gltf_ext/DELTAMESH_mesh_compression/samples/', import.meta.url);

async function load(url) {
  const scene = new Scene(new NullEngine());
  const bytes = readFileSync(url);
  const isBinary = url.pathname.endsWith('.glb');
  const source = isBinary ? new Uint8Array(bytes) : `data:${bytes.toString('utf8')}`;
  const { meshes } = await ImportMeshAsync(source, scene, { pluginExtension: isBinary ? '.glb' : '.gltf' });
  return meshes.filter((mesh) => mesh.getTotalVertices() > 0);
}

const arraysOf = (mesh) => ({
  indices: [...mesh.getIndices()],
  ...Object.fromEntries(mesh.getVerticesDataKinds().map((kind) => [kind, [...mesh.getVerticesData(kind)]])),
});

test('fallback data is what is decoded', async () => {
  const url = new URL('valid/cube_fallback.glb', samples);
  const plain = (await load(url)).map(arraysOf);
  const registered = registerDeltamesh();
  assert.deepEqual((await load(url)).map(arraysOf), plain);
  registered.dispose();
});

for (const name of readdirSync(new URL('valid/', samples))) {
  test(`reads ${name}`, async () => {
    const registered = registerDeltamesh();
    const meshes = await load(new URL(`valid/${name}`, samples));
    assert.ok(meshes.length > 0);
    for (const mesh of meshes) assert.ok(mesh.getIndices().every((index) => index < mesh.getTotalVertices()));
    registered.dispose();
  });
}

for (const name of readdirSync(new URL('invalid/', samples))) {
  test(`refuses ${name} by its rule`, async () => {
    const registered = registerDeltamesh();
    await assert.rejects(load(new URL(`invalid/${name}`, samples)), (error) => {
      assert.match(String(error), new RegExp(`\\[${name.split('_')[0]}\\]`));
      return true;
    });
    registered.dispose();
  });
}
