// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { test } from 'node:test';

import { DeltameshError, createDecoder } from '@deltamesh/decoder';
import { DeltameshLoader, gltfDeltameshExtension } from '@deltamesh/three';
import { createEncoder } from '@deltamesh/encoder';
import { LoadingManager } from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { PLYLoader } from 'three/addons/loaders/PLYLoader.js';

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

/** Of a PLY file whose colours are all that bytes can be. */
function plyOfColors() {
  const numbers = [...Array(256).keys()];
  const header = ['ply', 'format ascii 1.0', 'element vertex 256', ...['x', 'y', 'z'].map((name) => `property float ${name}`)];
  header.push(...['red', 'green', 'blue'].map((name) => `property uchar ${name}`), 'element face 254', 'property list uchar int vertex_indices', 'end_header');
  const vertices = numbers.map((i) => `${i} ${i % 2} ${i % 3} ${i} ${255 - i} ${(7 * i) % 256}`);
  return [...header, ...vertices, ...numbers.slice(2).map((i) => `3 ${i - 2} ${i - 1} ${i}`), ''].join('\n');
}

for (const [name, isConverted] of Object.entries({ red: true, color: true, COLOR_0: false, COLOR_1: false })) {
  test(`colours that are called ${name} are ${isConverted ? "converted as PLYLoader's" : 'linear already'}`, async () => {
    const expected = new PLYLoader().parse(plyOfColors());
    const values = Uint8Array.from([...Array(256).keys()].flatMap((i) => [i, 255 - i, (7 * i) % 256]));
    const mesh = { positions: expected.attributes.position.array, indices: Uint32Array.from(expected.index.array) };
    const attributes = [{ name, kind: 'color', components: 3, normalized: true, linear: !isConverted, values }];
    const { bytes } = (await createEncoder()).encode({ ...mesh, attributes }, { lossless: true, keepOrder: true });
    const { color } = (await new DeltameshLoader().parseAsync(bytes)).attributes;
    assert.equal(color.normalized, true);
    assert.deepEqual([...color.array], isConverted ? [...expected.attributes.color.array] : [...values]);
  });
}

/** Answers of fetch() to come; then what there is. */
function fetchAnswers(t, ...answers) {
  const usual = globalThis.fetch;
  t.mock.method(globalThis, 'fetch', async (...given) => (answers.length > 0 ? answers.shift()() : usual(...given)));
}
const found = (name) => () => new Response(golden(name));

test('a file that is not there, or bad, is an error that names it; the next load works', async (t) => {
  const manager = new LoadingManager();
  const failed = [];
  manager.onError = (url) => failed.push(url);
  const loader = new DeltameshLoader(manager);
  fetchAnswers(t, () => new Response('', { status: 503 }), () => new Response(new Uint8Array(9)), found('grid.bits6'));
  await assert.rejects(loader.loadAsync('http://host/a.dmsh'), /503/);
  await assert.rejects(loader.loadAsync('http://host/a.dmsh'), (error) => error.source === 'http://host/a.dmsh' && /^http:\/\/host\/a\.dmsh: /.test(error.message));
  assert.ok((await loader.loadAsync('http://host/a.dmsh')).index.count > 0);
  assert.deepEqual(failed, Array(2).fill('http://host/a.dmsh'));
});

test('the manager waits for geometries', async (t) => {
  fetchAnswers(t, found('asset.bounded'));
  const manager = new LoadingManager();
  let geometry;
  const loaded = new Promise((resolve) => (manager.onLoad = () => resolve(geometry)));
  new DeltameshLoader(manager).load('http://host/b.dmsh', (result) => (geometry = result));
  assert.ok(await loaded);
});

test('what is being loaded is aborted, and what is loaded later is not', async () => {
  const loader = new DeltameshLoader();
  const parsing = loader.parseAsync(golden('asset.bounded'));
  loader.abort();
  await assert.rejects(parsing, { name: 'AbortError' });
  assert.ok(await loader.parseAsync(golden('asset.bounded')));
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
      assert.match(error.source, /^mesh \d+.*, primitive \d+$/);
      return true;
    });
  });
}
