// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';

import { DeltameshError, createDecoder } from '@deltamesh/decoder';
import { createEncoder } from '@deltamesh/encoder';
import { EncoderWorker } from '@deltamesh/encoder/worker';

import { goldenStreams, hashOf, nativeEncodedHashes } from '../../decoder/test/streams.js';

function wavyGrid(size) {
  const positions = [];
  const indices = [];
  for (let y = 0; y < size; ++y) for (let x = 0; x < size; ++x) positions.push(x, y, 3 * Math.sin(x / 5) * Math.cos(y / 7));
  for (let y = 0; y + 1 < size; ++y) {
    for (let x = 0; x + 1 < size; ++x) {
      const v = y * size + x;
      indices.push(v, v + 1, v + size, v + 1, v + size + 1, v + size);
    }
  }
  return { positions: new Float32Array(positions), indices: new Uint32Array(indices) };
}

/** As encode_hash.cpp. */
const PER_MILLE = { value: 0.1, unit: 'diagonal' };
const WAYS = [
  { vde: PER_MILLE },
  { maxError: PER_MILLE },
  { lossless: true, keepOrder: true },
  { geometry: 'highpass', bits: 6, profile: 'zstd' },
  { geometry: 'predictive', effort: 2 },
];

test('streams have the bytes of the native encoder', async (t) => {
  const streams = goldenStreams().filter(({ path }) => /attributes.compact|grid.lossless|sphere.walked|asset.bounded/.test(path));
  const hashes = nativeEncodedHashes(streams.map(({ path }) => path));
  if (!hashes) return t.skip('the native encoder is not built');
  const [decoder, encoder] = await Promise.all([createDecoder(), createEncoder()]);
  for (const { path, bytes } of streams) {
    const mesh = await decoder.decode(bytes);
    for (const [number, way] of WAYS.entries()) {
      const encoded = encoder.encode(mesh, way);
      assert.ok(!(encoded instanceof DeltameshError), encoded.message);
      const name = `${path}, way ${number}`;
      assert.equal(hashOf([encoded.bytes]), hashes.get(name), name);
    }
  }
});

test('what is encoded decodes within its bound', async () => {
  const [decoder, encoder] = await Promise.all([createDecoder(), createEncoder()]);
  const mesh = wavyGrid(40);
  const shares = [];
  const { bytes, order } = encoder.encode(mesh, { maxError: 0.01, onProgress: (share) => shares.push(share) });
  const decoded = await decoder.decode(bytes);
  assert.ok(decoded.quality.maxError <= 0.01);
  assert.equal(shares.at(-1), 1);
  const comparison = encoder.compare(mesh, decoded, order);
  assert.equal(comparison.corresponding, true);
  assert.ok(comparison.quality.maxError <= 0.01);
  assert.equal(comparison.signedError.length, decoded.vertexCount);
  order.forEach((vertex, v) => {
    for (let axis = 0; axis < 3; ++axis)
      assert.ok(Math.abs(mesh.positions[3 * vertex + axis] - decoded.positions[3 * v + axis]) <= 0.01);
  });
});

test('attributes, groups and the origin come back', async () => {
  const [decoder, encoder] = await Promise.all([createDecoder(), createEncoder()]);
  const grid = wavyGrid(10);
  const mesh = {
    ...grid,
    origin: [1e6, -2e6, 0.5],
    groups: Array.from({ length: grid.indices.length / 3 }, (_, face) => (face < 50 ? 0 : 3)),
    attributes: [
      { name: 'COLOR_0', kind: 'color', components: 3, normalized: true, values: Uint8Array.from({ length: 300 }, (_, i) => i) },
      { name: 'confidence', kind: 'generic', components: 1, values: Float32Array.from({ length: 100 }, (_, i) => i / 7) },
    ],
  };
  const { bytes } = encoder.encode(mesh, { keepOrder: true, attributeErrors: { confidence: 0.01 } });
  const decoded = await decoder.decode(bytes);
  assert.deepEqual(decoded.origin, mesh.origin);
  assert.deepEqual([...decoded.groups], mesh.groups);
  assert.deepEqual(decoded.indices, mesh.indices);
  assert.deepEqual(decoded.attributes[0].values, mesh.attributes[0].values);
  assert.equal(decoded.attributes[1].name, 'confidence');
  decoded.attributes[1].values.forEach((value, i) => assert.ok(Math.abs(value - i / 7) <= 0.01 + 1e-6));
});

test('a number of each vertex keeps a mean error', async () => {
  const [decoder, encoder] = await Promise.all([createDecoder(), createEncoder()]);
  const values = Float32Array.from({ length: 2500 }, (_, i) => 20 * Math.sin(i / 9) + (i % 50));
  const mesh = { ...wavyGrid(50), attributes: [{ name: 'intensity', kind: 'generic', components: 1, values }] };
  const { bytes } = encoder.encode(mesh, { keepOrder: true, attributeRms: { intensity: 2 } });
  const [decoded] = (await decoder.decode(bytes)).attributes;
  const squares = decoded.values.reduce((sum, value, i) => sum + (value - values[i]) ** 2, 0);
  const rms = Math.sqrt(squares / values.length);
  assert.ok(rms > 1.5 && rms <= 2.0001, `${rms}`);
});

test('bad options and meshes are errors, as requests that cannot be met', async () => {
  const encoder = await createEncoder();
  const mesh = wavyGrid(10);
  const codeOf = (given, options) => encoder.encode({ ...mesh, ...given }, options).code;
  assert.equal(codeOf({}, { effort: 12 }), 200);
  assert.equal(codeOf({}, { geometry: 'other' }), 200);
  assert.equal(codeOf({}, { maxError: 1, bits: 8 }), 200);
  assert.equal(codeOf({ positions: [0, 0, 0] }), 200);
  assert.equal(codeOf({ indices: Uint32Array.of(0, 1, 100) }), 201);
  assert.equal(codeOf({ positions: mesh.positions.map(() => NaN) }), 204);
  const unmet = encoder.encode(mesh, { targetBytes: 20 });
  assert.equal(unmet.code, 203);
  assert.ok(unmet.best.bytes > 20);
  assert.ok(encoder.encode(mesh).bytes.length > 0);
});

test('a worker encodes, tells of its progress, is cancelled, and goes on', async () => {
  const worker = new EncoderWorker();
  const mesh = wavyGrid(30);
  const shares = [];
  const { bytes, order } = await worker.encode(mesh, { maxError: 0.01, onProgress: (share) => shares.push(share) });
  assert.deepEqual(bytes, (await createEncoder()).encode(mesh, { maxError: 0.01 }).bytes);
  assert.ok(shares.length > 0);
  const decoded = await (await createDecoder()).decode(bytes);
  assert.ok((await worker.compare(mesh, decoded, order)).quality.maxError <= 0.01);
  assert.equal((await worker.encode(mesh, { effort: 12 })).code, 200);
  const cube = readFileSync(new URL('../../../../gltf_ext/DELTAMESH_mesh_compression/samples/valid/cube.glb', import.meta.url));
  const packed = await worker.packGltf(cube); // by other packages' tests, too
  assert.deepEqual(packed, (await createEncoder()).packGltf(cube));
  assert.deepEqual([packed.report.primitives, packed.report.converted, packed.report.otherwiseCompressed], [1, 0, 1]);
  assert.ok((await worker.encode(mesh, { targetBytes: 20 })).best.bytes > 20);

  const controller = new AbortController();
  const cancelled = worker.encode(wavyGrid(200), { signal: controller.signal, onProgress: () => controller.abort() });
  await assert.rejects(cancelled, { name: 'AbortError' });
  assert.deepEqual((await worker.encode(mesh, { maxError: 0.01 })).bytes, bytes);
  const unfinished = [worker.encode(mesh), worker.encode(mesh)];
  await new Promise((resolve) => setImmediate(resolve)); // the first has begun
  worker.dispose();
  for (const { reason } of await Promise.allSettled([...unfinished, worker.encode(mesh)])) assert.match(String(reason?.message), /disposed of/);
});
