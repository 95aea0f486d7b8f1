// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';

const bytes = readFileSync(new URL('../../build/web/simd/small_test.wasm', import.meta.url));

async function load() {
  const memory = new WebAssembly.Memory({ initial: 32, maximum: 65536 });
  const env = {
    memory,
    emscripten_notify_memory_growth() {},
    out_of_memory() {
      throw new RangeError('out of memory');
    },
    proc_exit(code) {
      throw new Error(`exit ${code}`);
    },
  };
  const { instance } = await WebAssembly.instantiate(bytes, { env, wasi_snapshot_preview1: env });
  instance.exports._initialize();
  return instance.exports;
}

test('the vector of the modules is like the one of the standard', async () => {
  assert.equal((await load()).test(), 0, 'line of web/wasm/small_test.cpp');
});

test('more elements than can be addressed are refused', async () => {
  const module = await load();
  assert.equal(module.sum_of_zeros(1000), 0);
  for (const count of [2 ** 28, 2 ** 29, 2 ** 29 + 1, 2 ** 32 - 1]) assert.throws(() => module.sum_of_zeros(count), RangeError);
});
