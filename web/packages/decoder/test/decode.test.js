// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';

import { DeltameshError, createDecoder, supportsSimd } from '@deltamesh/decoder';

import { goldenStreams, meshHash, nativeHashes, streamPaths } from './streams.js';

const golden = (name) => readFileSync(streamPaths().find((path) => path.includes(`/golden/${name}.`)));

for (const simd of [true, false]) {
  test(`every stream decodes to the native decoder's bits, ${simd ? 'with' : 'without'} SIMD`, async (t) => {
    const paths = streamPaths();
    const hashes = nativeHashes(paths);
    if (!hashes) return t.skip('the native decoder is not built');
    const decoder = await createDecoder({ simd });
    for (const path of paths) {
      const mesh = await decoder.decode(readFileSync(path));
      assert.ok(!(mesh instanceof DeltameshError), `${path}: ${mesh.message}`);
      assert.equal(meshHash(mesh), hashes.get(path), path);
    }
  });
}

test('SIMD is there', () => assert.equal(supportsSimd(), true));

test('a mesh has what its stream says', async () => {
  const decoder = await createDecoder();
  const bytes = golden('asset.bounded');
  const info = decoder.inspect(bytes);
  const mesh = await decoder.decode(bytes);
  assert.equal(mesh.positions.length, 3 * info.vertexCount);
  assert.equal(mesh.indices.length, 3 * info.triangleCount);
  assert.equal(mesh.groups.length, info.triangleCount);
  assert.deepEqual(
    mesh.attributes.map(({ values, ...attribute }) => attribute),
    info.attributes,
  );
  assert.deepEqual(
    mesh.attributes.slice(0, 4).map(({ name, kind, components, values }) => [name, kind, components, values.constructor]),
    [
      ['TANGENT', 'tangent', 4, Float32Array],
      ['NORMAL', 'normal', 3, Float32Array],
      ['TEXCOORD_0', 'uv', 2, Float32Array],
      ['COLOR_0', 'color', 4, Uint8Array],
    ],
  );
  assert.ok(info.quality.maxError >= 0);
  assert.ok(info.chunks.some(({ tag, codedBytes }) => tag === 'CONN' && codedBytes > 0));
});

test('limits are kept to', async () => {
  const decoder = await createDecoder();
  const bytes = golden('asset.bounded');
  for (const limits of [{ vertices: 10 }, { triangles: 10 }, { attributes: 1 }, { attributeBytes: 100 }]) {
    const error = await decoder.decode(bytes, { limits });
    assert.ok(error instanceof DeltameshError);
    assert.ok([202, 104].includes(error.code), JSON.stringify(limits) + error.message);
  }
});

/** As WebAssembly writes a constant. */
function signedLeb(number) {
  const bytes = [];
  for (;;) {
    const byte = number & 127;
    number >>= 7;
    if ((number === 0 && !(byte & 64)) || (number === -1 && byte & 64)) return [...bytes, byte];
    bytes.push(byte | 128);
  }
}

test('memory beyond its limit is an error, and the decoder goes on', async () => {
  const decoder = await createDecoder({ maxMemory: 2 ** 21 });
  const large = await decoder.decode(new Uint8Array(2 ** 21));
  assert.equal(large.code, 900);
  const mesh = await decoder.decode(golden('tetrahedron.default'));
  assert.equal(mesh.vertexCount, 4);
});

test('many at a time', async () => {
  const decoder = await createDecoder();
  const streams = goldenStreams();
  const once = await Promise.all(streams.map(({ bytes }) => decoder.decode(bytes)));
  const alone = [];
  for (const { bytes } of streams) alone.push(await decoder.decode(bytes));
  assert.deepEqual(once.map(meshHash), alone.map(meshHash));
});

test('decoding at once needs what is loaded', async () => {
  const decoder = await createDecoder();
  const bytes = golden('grid.bits6');
  assert.equal(decoder.decodeSync(bytes).code, 300);
  await decoder.load('highpass');
  assert.equal(meshHash(decoder.decodeSync(bytes)), meshHash(await decoder.decode(bytes)));
});

test('a stream tells which modules it needs', async () => {
  const decoder = await createDecoder();
  const needs = { 'tetrahedron.default': [], 'grid.bits6': ['highpass'], 'grid.zstd': ['highpass', 'zstd'], 'room.voxels': ['grid'], 'floats.lossless': ['rare'], 'asset.bounded': ['rare'] };
  for (const [name, modules] of Object.entries(needs)) assert.deepEqual(decoder.inspect(golden(name)).modules, modules, name);
});

test('a module that cannot be loaded is an error', async () => {
  const missing = new URL('./missing.wasm', import.meta.url);
  await assert.rejects(createDecoder({ files: { core: missing } }));
  const decoder = await createDecoder({ files: { highpass: missing } });
  const error = await decoder.decode(golden('grid.bits6'));
  assert.equal(error.code, 300);
  const withoutRare = await createDecoder({ files: { rare: missing } });
  assert.equal((await withoutRare.decode(golden('floats.lossless'))).code, 300);
  const withoutGrid = await createDecoder({ files: { grid: missing } });
  assert.equal((await withoutGrid.decode(golden('room.voxels'))).code, 300);
  const withoutZstd = await createDecoder({ files: { zstd: missing } });
  assert.equal((await withoutZstd.decode(golden('grid.zstd'))).code, 300);
  assert.equal((await decoder.decode(golden('grid.predictive'))).code, undefined);
});

test('a module of another release is an error', async () => {
  const bytes = readFileSync(new URL('../grid.wasm', import.meta.url));
  const release = (module, given) => new WebAssembly.Instance(module, { env: given }).exports.release_of();
  const memory = new WebAssembly.Memory({ initial: 32, maximum: 2 ** 16 });
  const own = new DataView(new ArrayBuffer(4));
  own.setInt32(0, release(new WebAssembly.Module(bytes), { memory, allocate() {}, release() {} }), true);
  const constant = [0x41, ...signedLeb(own.getInt32(0, true))];
  const at = bytes.findIndex((_, i) => constant.every((byte, k) => bytes[i + k] === byte));
  assert.ok(at > 0);
  const other = Uint8Array.from(bytes);
  other[at + 1] ^= 1;
  const decoder = await createDecoder({ files: { grid: other } });
  const error = await decoder.decode(golden('room.voxels'));
  assert.equal(error.code, 300);
  assert.match(error.message, /grid is of another release/);
  assert.equal((await decoder.decode(golden('grid.predictive'))).code, undefined);
});

test('a limit of memory is a number', async () => {
  for (const maxMemory of [NaN, -1, 'much']) {
    const decoder = await createDecoder({ maxMemory });
    assert.equal((await decoder.decode(golden('grid.predictive'))).code, 200);
  }
  for (const maxMemory of [Infinity, 2 ** 40, 0])
    assert.equal((await (await createDecoder({ maxMemory })).decode(golden('tetrahedron.default'))).vertexCount, 4);
});

test('modules may be views of one buffer', async () => {
  const names = ['core', 'highpass', 'rare', 'grid', 'zstd'];
  const parts = names.map((name) => readFileSync(new URL(`../${name}.wasm`, import.meta.url)));
  const all = new Uint8Array(parts.reduce((sum, { length }) => sum + length, 0));
  const files = {};
  let at = 0;
  for (const [i, part] of parts.entries()) {
    all.set(part, at);
    files[names[i]] = all.subarray(at, at + part.length);
    at += part.length;
  }
  const decoder = await createDecoder({ files });
  const [given, usual] = [await decoder.decode(golden('attributes.zstd')), await (await createDecoder()).decode(golden('attributes.zstd'))];
  assert.equal(meshHash(given), meshHash(usual));
});
