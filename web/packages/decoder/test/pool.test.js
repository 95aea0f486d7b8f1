// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
import assert from 'node:assert/strict';
import { getEventListeners } from 'node:events';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';

import { DeltameshError } from '@deltamesh/decoder';
import { DecoderPool } from '@deltamesh/decoder/pool';

import { startWorker } from '../start-worker.js';
import WORKER from '../worker-text.js';
import { goldenStreams, meshHash } from './streams.js';

const streams = goldenStreams();

for (const workers of [0, 2]) {
  test(`a pool of ${workers} workers decodes, refuses, cancels and ends`, async () => {
    const pool = new DecoderPool({ workers });
    const meshes = await Promise.all(streams.map(({ bytes }) => pool.decode(bytes)));
    for (const mesh of meshes) assert.ok(!(mesh instanceof DeltameshError), mesh.message);
    const alone = new DecoderPool({ workers: 0 });
    for (const [i, { bytes, path }] of streams.entries())
      assert.equal(meshHash(meshes[i]), meshHash(await alone.decode(bytes)), path);

    const refused = await pool.decode(new Uint8Array(50));
    assert.ok(refused instanceof DeltameshError);
    assert.equal(refused.code, 101);
    assert.equal((await pool.decode(streams[0].bytes, { limits: { vertices: 1 } })).code, 202);

    const controller = new AbortController();
    const cancelled = streams.map(({ bytes }) => pool.decode(bytes, { signal: controller.signal }));
    controller.abort();
    for (const result of await Promise.allSettled(cancelled)) assert.equal(result.reason?.name, 'AbortError');
    assert.equal(meshHash(await pool.decode(streams[0].bytes)), meshHash(meshes[0]));

    const { signal } = new AbortController();
    await Promise.all(streams.map(({ bytes }) => pool.decode(bytes, { signal })));
    assert.equal(getEventListeners(signal, 'abort').length, 0);

    const unfinished = pool.decode(streams[0].bytes);
    pool.dispose();
    await assert.rejects(unfinished);
    await assert.rejects(pool.decode(streams[0].bytes));
  });
}

test('pools share their workers, however many there are', async () => {
  let started = 0;
  const createWorker = () => {
    ++started;
    return startWorker(WORKER);
  };
  const pools = Array.from({ length: 100 }, () => new DecoderPool({ workers: 2, createWorker }));
  const meshes = await Promise.all(pools.map((pool) => pool.decode(streams[0].bytes)));
  assert.equal(new Set(meshes.map(meshHash)).size, 1);
  assert.equal(started, 2);
  for (const pool of pools.slice(1)) pool.dispose();
  assert.equal(meshHash(await pools[0].decode(streams[0].bytes)), meshHash(meshes[0]));
  pools[0].dispose();
  assert.equal(started, 2);
});

test('what could not be loaded or started is tried again, and loaded once', async () => {
  const core = readFileSync(new URL('../core.wasm', import.meta.url));
  let asked = 0;
  const load = async () => {
    if (++asked === 1) throw new Error('no net');
    return core;
  };
  const pool = new DecoderPool({ workers: 1, decoder: { files: { core: load } } });
  await assert.rejects(pool.preload(), /the module core could not be loaded: no net/);
  await pool.preload();
  assert.ok(!((await pool.decode(streams[0].bytes)) instanceof DeltameshError));
  assert.equal(asked, 2);
  pool.dispose();

  let started = 0;
  const createWorker = () => startWorker(++started === 1 ? 'throw new Error("no start")' : WORKER);
  const other = new DecoderPool({ workers: 1, createWorker });
  await assert.rejects(other.decode(streams[0].bytes), /the worker failed: no start/);
  assert.ok(!((await other.decode(streams[0].bytes)) instanceof DeltameshError));
  other.dispose();
});

test('streams are taken as any bytes, and what is none is refused by its name', async () => {
  const pool = new DecoderPool();
  const { buffer } = new Uint8Array(streams[0].bytes);
  const shared = new SharedArrayBuffer(buffer.byteLength);
  new Uint8Array(shared).set(new Uint8Array(buffer));
  for (const bytes of [buffer, shared, new DataView(buffer)]) assert.equal(meshHash(await pool.decode(bytes)), meshHash(await pool.decode(streams[0].bytes)));
  for (const [given, kind] of [['text', 'String'], [undefined, 'undefined'], [[1], 'Array']]) {
    const error = await pool.decode(given);
    assert.equal(error.code, 200);
    assert.match(error.message, new RegExp(`not as ${kind}`));
  }
  pool.dispose();
});
