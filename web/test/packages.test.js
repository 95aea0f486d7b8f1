// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync, readdirSync } from 'node:fs';
import { test } from 'node:test';
import { brotliCompressSync } from 'node:zlib';

const packages = new URL('../packages/', import.meta.url);
const sizeOf = (path) => brotliCompressSync(readFileSync(new URL(path, packages))).length;

/** Largest sizes after brotli, bytes. */
const SIZES = { 'decoder/worker-text.js': 3500, 'decoder/core.wasm': 60000, 'decoder/highpass.wasm': 35500, 'decoder/zstd.wasm': 18500, 'decoder/rare.wasm': 34500, 'decoder/grid.wasm': 41500 };

for (const [path, most] of Object.entries(SIZES)) {
  test(`${path} is not larger than its bound`, (t) => {
    const size = sizeOf(path);
    t.diagnostic(`${size} bytes after brotli`);
    assert.ok(size <= most);
  });
}

/** What JavaScript gives to modules; emscripten makes an import of every symbol that is missing. */
const GIVEN = ['memory', 'out_of_memory', 'progress'];
/** What a part gets of core. */
const OF_CORE = ['memory', 'allocate', 'release'];
const PARTS = ['highpass', 'zstd', 'rare', 'grid'];

const moduleOf = (path) => new WebAssembly.Module(readFileSync(new URL(path, packages)));

for (const path of readdirSync(packages, { recursive: true }).filter((path) => path.endsWith('.wasm'))) {
  test(`${path} imports nothing that is not given`, () => {
    const isPart = PARTS.some((part) => path.startsWith(`decoder/${part}`));
    for (const { module, name } of WebAssembly.Module.imports(moduleOf(path))) {
      if (PARTS.includes(module)) {
        const exported = WebAssembly.Module.exports(moduleOf(`decoder/${module}.wasm`));
        assert.ok(exported.some((one) => one.name === name), `${module}.wasm exports ${name}`);
      } else {
        assert.ok((isPart ? OF_CORE : GIVEN).includes(name), name);
      }
    }
  });
}

/** Largest sizes of what is packed, bytes: about 1 % above what it is. */
const PACKED = { decoder: 1410000, encoder: 1000000 };
const PACKED_OTHERS = 12000;

const typesOf = (path) => path.replace(/\.js$/, '.d.ts');

for (const name of readdirSync(packages)) {
  test(`${name} is packed with all that it exports, types and licences, and nothing else`, (t) => {
    const folder = new URL(`${name}/`, packages);
    const { exports, license } = JSON.parse(readFileSync(new URL('package.json', folder)));
    const [{ files, size }] = JSON.parse(execFileSync('npm', ['pack', '--dry-run', '--json', '--ignore-scripts'], { cwd: folder, encoding: 'utf8' }));
    const packed = files.map(({ path }) => `./${path}`);
    for (const target of Object.values(exports)) {
      if (typeof target === 'string') assert.ok(target.includes('*') || packed.includes(target), target);
      else for (const path of [target.default, target.types]) assert.ok(packed.includes(path), path);
      if (target.default) assert.equal(target.types, typesOf(target.default));
    }
    const others = packed.filter((path) => !/^\.\/(text\/)?[\w-]+(\.js|\.d\.ts|\.wasm)$/.test(path));
    const carriesModules = packed.some((path) => path.endsWith('.wasm'));
    assert.deepEqual(others.sort(), ['./LICENSE', ...(carriesModules ? ['./NOTICE'] : []), './README.md', './package.json']);
    assert.equal(license, 'Apache-2.0');
    t.diagnostic(`${size} bytes in ${files.length} files`);
    assert.ok(size <= (PACKED[name] ?? PACKED_OTHERS));
  });
}

/** Every import of a package's scripts, by its text. */
function* importsOf(folder) {
  for (const name of readdirSync(folder).filter((name) => name.endsWith('.js') && name !== 'deltamesh.js'))
    for (const [, from] of readFileSync(new URL(name, folder), 'utf8').matchAll(/(?:from|import\() ?'([^']+)'/g)) yield { name, from };
}

for (const name of readdirSync(packages)) {
  test(`${name} imports what it depends on, and nothing that browsers do not have`, () => {
    const folder = new URL(`${name}/`, packages);
    const { dependencies = {}, peerDependencies = {} } = JSON.parse(readFileSync(new URL('package.json', folder)));
    const known = Object.keys({ ...dependencies, ...peerDependencies });
    for (const { name, from } of importsOf(folder)) {
      if (from.startsWith('./')) assert.ok(existsSync(new URL(from, folder)), `${name}: ${from}`);
      else assert.ok(known.some((each) => from === each || from.startsWith(`${each}/`)), `${name}: ${from}`);
    }
  });
}
