// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { DeltameshError, createDecoder } from '@deltamesh/decoder';
import { xxhash3 } from 'hash-wasm';

import { goldenStreams, invalidStreams } from './streams.js';

const CHECKSUM_BYTES = 4;

/** With the checksum that its bytes ask for, so that what lies behind the check is reached. */
async function withChecksum(stream) {
  const covered = stream.length - CHECKSUM_BYTES;
  const hash = BigInt(`0x${await xxhash3(stream.subarray(0, covered))}`);
  new DataView(stream.buffer, stream.byteOffset).setUint32(covered, Number(hash & 0xffffffffn), true);
  return stream;
}

/** Numbers that look random, the same on every run. */
function* numbers() {
  let state = 12345;
  for (;;) yield (state = (Math.imul(state, 1664525) + 1013904223) >>> 0) / 2 ** 32;
}

test('every beginning of a stream is an error', async () => {
  const decoder = await createDecoder();
  for (const { path, bytes } of goldenStreams()) {
    for (let part = 0; part < 20; ++part) {
      const error = await decoder.decode(bytes.subarray(0, Math.floor((bytes.length * part) / 20)));
      assert.ok(error instanceof DeltameshError, path);
      assert.ok(error.code < 200 && error.rule !== '', error.message);
    }
  }
});

test('streams that break a rule are refused with its tag', async () => {
  const decoder = await createDecoder();
  for (const { name, rule, bytes } of invalidStreams()) {
    const error = await decoder.decode(bytes);
    assert.equal(error instanceof DeltameshError && error.rule, rule, name);
  }
});

test('damaged bytes behind a checksum that fits are an error or another mesh, never a failure', async () => {
  const decoder = await createDecoder();
  const random = numbers();
  const upTo = (count) => Math.floor(random.next().value * count);
  const codes = new Map();
  for (const { path, bytes } of goldenStreams()) {
    for (let turn = 0; turn < 40; ++turn) {
      const damaged = new Uint8Array(bytes);
      for (let i = 0; i <= turn % 3; ++i) damaged[4 + upTo(bytes.length - 8)] ^= 1 + upTo(255);
      const result = await decoder.decode(await withChecksum(damaged), { limits: { vertices: 1e6, triangles: 1e6 } });
      const code = result instanceof DeltameshError ? result.code : 0;
      codes.set(code, (codes.get(code) ?? 0) + 1);
      assert.ok(code < 900, `${path}, turn ${turn}: ${result.message}`);
      if (code === 0) assert.ok(result.indices.every((index) => index < result.vertexCount));
    }
  }
  assert.ok(codes.get(104) > 100);
});

test('an error says what, where and which rule', async () => {
  const decoder = await createDecoder();
  const [{ bytes }] = goldenStreams();
  const damaged = new Uint8Array(bytes);
  damaged[20] ^= 1;
  const error = await decoder.decode(damaged);
  assert.equal(error.code, 103);
  assert.equal(error.rule, 'CNT-2');
  assert.deepEqual(error.where, { unit: 'byte', position: bytes.length - 4 });
  assert.equal(
    error.message,
    `the checksum does not match: the stream is damaged or cut off, byte ${bytes.length - 4} [CNT-2]`,
  );
});
