// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Bundles the page and its workers into dist/, beside the modules in WebAssembly.
import { copyFile, mkdir, readFile, rm, writeFile } from 'node:fs/promises';
import { basename } from 'node:path';
import { gzipSync } from 'node:zlib';

import { DeltameshError } from '@deltamesh/decoder';
import { createEncoder } from '@deltamesh/encoder';
import { build } from 'esbuild';

import { bakeStudio } from './bake-studio.js';
import { EXAMPLES, makeExample } from './src/mesh/examples.js';
import { packOrder } from './src/mesh/prepared.js';
import { DEFAULTS, encodeOptions } from './src/settings.js';
import { takeStills } from './take-stills.js';

const here = new URL('./', import.meta.url);
const dist = new URL('dist/', here);

const FILES = [
  '@deltamesh/decoder/core.wasm',
  '@deltamesh/decoder/highpass.wasm',
  '@deltamesh/decoder/zstd.wasm',
  '@deltamesh/decoder/rare.wasm',
  '@deltamesh/decoder/grid.wasm',
  '@deltamesh/decoder/map.wasm',
  '@deltamesh/encoder/encoder.wasm',
  'draco3d/draco_encoder.wasm',
  'draco3d/draco_decoder.wasm',
];

await rm(dist, { recursive: true, force: true });
await mkdir(dist, { recursive: true });
const OPTIONS = {
  outdir: dist.pathname,
  entryNames: '[name]',
  chunkNames: 'part-[hash]',
  bundle: true,
  minify: true,
  sourcemap: true,
  format: 'esm',
  target: 'es2022',
  external: ['node:*', 'fs', 'path', './text/*'], // of modules that run in node, too; texts of modules that are there as files
  logLevel: 'warning',
};
const pathOf = (name) => new URL(`src/${name}.js`, here).pathname;
const PARTS = ['main', 'page', 'workers/read-worker', 'workers/codec-worker', 'workers/decode-worker', 'workers/live-worker', 'workers/map-worker', 'workers/pack-worker', 'workers/peers-worker', 'workers/renderer-worker'];
const { metafile } = await build({ ...OPTIONS, entryPoints: PARTS.map(pathOf), splitting: true, metafile: true });
await build({ ...OPTIONS, entryPoints: [pathOf('workers/example-worker')] });

/** Files that the first picture needs, all at once: otherwise each is asked for when the one before it is there. */
function preloads() {
  const outputs = Object.entries(metafile.outputs).map(([path, output]) => [basename(path), output]);
  const staticOf = (name) => outputs.find(([path]) => path === name)[1].imports.filter(({ kind, external }) => kind === 'import-statement' && !external);
  const scripts = new Set(['page.js']);
  for (const script of [...scripts, 'main.js']) for (const { path } of staticOf(script)) scripts.add(basename(path));
  return [...scripts].map((name) => `<link rel="modulepreload" href="${name}" />`).join('\n    ');
}

const html = (await readFile(new URL('index.html', here), 'utf8')).replace('<!-- preloads -->', preloads());
const writePage = (still) => writeFile(new URL('index.html', dist), html.replace('<!-- still -->', still));
await writePage('');
await copyFile(new URL('style.css', here), new URL('style.css', dist));
await copyFile(new URL('../../LICENSE', here), new URL('LICENSE', dist));
for (const name of FILES) await copyFile(new URL(import.meta.resolve(name)), new URL(name.split('/').pop(), dist));
await copyFile(new URL(import.meta.resolve('draco3d/draco_decoder_nodejs.js')), new URL('draco_wasm_wrapper.js', dist)); // by DRACOLoader's name

// What the page has parts of.
const three = new URL('../LICENSE', import.meta.resolve('three')); // of build/three.module.js
const meshoptimizer = new URL('LICENSE.md', import.meta.resolve('meshoptimizer'));
const notice = new URL('NOTICE', import.meta.resolve('@deltamesh/encoder'));
const modules = new URL('../node_modules/', here);
const [core, graph, ktx] = ['@gltf-transform/core/LICENSE.md', 'property-graph/LICENSE', 'ktx-parse/LICENSE'].map((path) => new URL(path, modules));
const licences = await Promise.all([three, meshoptimizer, notice, core, graph, ktx].map((file) => readFile(file, 'utf8')));
const [ofThree, ofMeshoptimizer, ofModules, ofTransform, ofGraph, ofKtx] = licences;
await writeFile(
  new URL('NOTICE', dist),
  `=== three.js\n\n${ofThree}\n=== meshoptimizer\n\n${ofMeshoptimizer}\n=== glTF-Transform\n\n${ofTransform}\n=== property-graph\n\n${ofGraph}\n=== ktx-parse\n\n${ofKtx}\n=== Draco\n\nApache License 2.0, see LICENSE. Copyright The Draco Authors.\n\n${ofModules}`,
);

await writeFile(new URL('studio.gz', dist), gzipSync(bakeStudio()));

// The examples as streams, so that nobody waits for the encoder.
const encoder = await createEncoder();
for (const name of Object.keys(EXAMPLES)) {
  const encoded = encoder.encode(makeExample(name).mesh, encodeOptions(DEFAULTS));
  if (encoded instanceof DeltameshError) throw encoded;
  await writeFile(new URL(`${name}.dmsh`, dist), encoded.bytes);
  await writeFile(new URL(`${name}.order.gz`, dist), gzipSync(packOrder(encoded.order)));
}

await writePage(await takeStills(dist));
