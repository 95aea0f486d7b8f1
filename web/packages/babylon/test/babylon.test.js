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
import { createDecoder } from '@deltamesh/decoder';

Logger.LogLevels = Logger.NoneLogLevel;
const samples = new URL('../../../../gltf_ext/DELTAMESH_mesh_compression/samples/', import.meta.url);

function golden(name) {
  const folder = new URL('../../../../tests/golden/', import.meta.url);
  const file = readdirSync(folder).find((other) => other.startsWith(`${name}.`) && other.endsWith('.dmsh'));
  return new Uint8Array(readFileSync(new URL(file, folder)));
}

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
      assert.match(String(error), new RegExp(`mesh \\d+.*, primitive \\d+: .*\\[${name.split('_')[0]}\\]`));
      return true;
    });
    registered.dispose();
  });
}

test('a stream becomes a mesh with attributes, submeshes and quality', async () => {
  const registered = registerDeltamesh();
  const bytes = golden('asset.bounded');
  const stream = await (await createDecoder()).decode(bytes);
  const { meshes } = await ImportMeshAsync(bytes, new Scene(new NullEngine()), { pluginExtension: '.dmsh' });
  const [mesh] = meshes;
  assert.equal(mesh.getTotalVertices(), stream.vertexCount);
  assert.deepEqual(Float32Array.from(mesh.getVerticesData('position')), stream.positions);
  for (const kind of ['normal', 'tangent', 'uv', 'color', 'matricesIndices', 'matricesWeights'])
    assert.ok(mesh.isVerticesDataPresent(kind), kind);
  const color = stream.attributes.find(({ kind }) => kind === 'color');
  // Linear in the stream, as it is glTF's.
  const [, , , alpha] = mesh.getVerticesData('color');
  assert.equal(alpha, Math.fround(color.values[3] / 255));
  const linear = color.values[0] / 255;
  const srgb = linear <= 0.0031308 ? 12.92 * linear : 1.055 * linear ** (1 / 2.4) - 0.055;
  assert.ok(Math.abs(mesh.getVerticesData('color')[0] - srgb) < 1e-6);
  assert.deepEqual(mesh.metadata.deltamesh.quality, stream.quality);
  assert.deepEqual(mesh.subMeshes.map(({ materialIndex }) => materialIndex), [...new Set(stream.groups)].sort((a, b) => a - b));
  for (const { materialIndex, indexCount } of mesh.subMeshes)
    assert.equal(indexCount, 3 * stream.groups.filter((group) => group === materialIndex).length);
  registered.dispose();
});

test('a bad stream rejects with what is wrong', async () => {
  const registered = registerDeltamesh();
  const loading = ImportMeshAsync(new Uint8Array(100), new Scene(new NullEngine()), { pluginExtension: '.dmsh' });
  await assert.rejects(loading, /HDR-1/);
  registered.dispose();
});
