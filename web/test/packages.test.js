// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync, readdirSync } from 'node:fs';
import { test } from 'node:test';
import { brotliCompressSync } from 'node:zlib';

const packages = new URL('../packages/', import.meta.url);
const sizeOf = (path) => brotliCompressSync(readFileSync(new URL(path, packages))).length;

/** Largest sizes after brotli, bytes. They keep the modules from growing; the aims are lower (core 60 kB). */
const SIZES = { 'decoder/decoder.js': 5000, 'decoder/core.wasm': 91000, 'decoder/highpass.wasm': 66000, 'decoder/zstd.wasm': 11500 };

for (const [path, most] of Object.entries(SIZES)) {
  test(`${path} is not larger than its bound`, (t) => {
    const size = sizeOf(path);
    t.diagnostic(`${size} bytes after brotli`);
    assert.ok(size <= most);
  });
}

/** What JavaScript gives to modules; emscripten makes an import of every symbol that is missing. */
const IMPORTS = [
  'memory', 'out_of_memory', 'emscripten_notify_memory_growth', 'proc_exit',
  'give', 'solve', 'take', 'frameSize', 'expand', 'progress',
];

for (const path of readdirSync(packages, { recursive: true }).filter((path) => path.endsWith('.wasm'))) {
  test(`${path} imports nothing that is not given`, () => {
    const imports = WebAssembly.Module.imports(new WebAssembly.Module(readFileSync(new URL(path, packages))));
    assert.deepEqual(imports.map(({ name }) => name).filter((name) => !IMPORTS.includes(name)), []);
  });
}

for (const name of readdirSync(packages)) {
  test(`${name} is packed with all that it exports`, () => {
    const folder = new URL(`${name}/`, packages);
    const { exports } = JSON.parse(readFileSync(new URL('package.json', folder)));
    const [{ files }] = JSON.parse(execFileSync('npm', ['pack', '--dry-run', '--json'], { cwd: folder, encoding: 'utf8' }));
    const packed = files.map(({ path }) => `./${path}`);
    const exported = Object.values(exports).flatMap((target) => (typeof target === 'string' ? [target] : Object.values(target)));
    for (const path of exported.filter((path) => !path.includes('*'))) assert.ok(packed.includes(path), path);
    assert.ok(packed.includes('./README.md'));
    assert.ok(packed.every((path) => !path.includes('test')));
  });
}
