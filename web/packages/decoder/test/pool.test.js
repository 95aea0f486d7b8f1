// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
import assert from 'node:assert/strict';
import { getEventListeners } from 'node:events';
import { test } from 'node:test';

import { DeltameshError } from '@deltamesh/decoder';
import { DecoderPool } from '@deltamesh/decoder/pool';

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
