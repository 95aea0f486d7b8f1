// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Scripts that packages carry beside their sources, made from these: modules in WebAssembly as texts, workers as texts, and the decoder
// with all of that in one script.
import { mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';

import { build } from 'esbuild';

const packages = new URL('packages/', import.meta.url);
const HEAD = '// SPDX-License-Identifier: Apache-2.0\n// Copyright 2026 The deltamesh authors\n';

/** Of each package: the modules, and the worker's script. */
const TEXTS = {
  decoder: { modules: ['core', 'highpass', 'rare', 'grid', 'zstd', 'map'], worker: 'worker.js' },
  encoder: { modules: ['encoder'], worker: 'encode-worker.js' },
};

function write(url, about, text) {
  writeFileSync(url, `${HEAD}// ${about}: web/build-texts.js made it.\nexport default ${JSON.stringify(text)};\n`);
}

async function bundle(url, options) {
  const { outputFiles } = await build({
    entryPoints: [fileURLToPath(url)],
    bundle: true,
    minify: true,
    write: false,
    format: 'iife',
    target: 'es2022',
    define: { 'import.meta.url': 'undefined' }, // a script has none
    logLevel: 'warning',
    ...options,
  });
  return outputFiles[0].text;
}

for (const [name, { modules, worker }] of Object.entries(TEXTS)) {
  const folder = new URL(`${name}/`, packages);
  const texts = new URL('text/', folder);
  rmSync(texts, { recursive: true, force: true });
  mkdirSync(texts);
  for (const module of modules) {
    const packed = gzipSync(readFileSync(new URL(`${module}.wasm`, folder)), { level: 9 });
    write(new URL(`${module}.js`, texts), `${module}.wasm, gzip, base64`, packed.toString('base64'));
  }
  // What a worker shares with the page must not bring the page's own worker along.
  const page = { name: 'page', setup: ({ onLoad }) => onLoad({ filter: /modules\.js$/ }, () => ({ contents: 'export const compileGiven = 0, compileOwn = 0;' })) };
  write(new URL('worker-text.js', folder), `${worker} and what it imports`, await bundle(new URL(worker, folder), { plugins: [page] }));
}
const single = await bundle(new URL('decoder/single.js', packages), { globalName: 'deltamesh' });
writeFileSync(new URL('decoder/deltamesh.js', packages), HEAD + single);
