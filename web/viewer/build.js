// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Bundles the page and its workers into dist/, beside the modules in WebAssembly.
import { copyFile, mkdir, readFile, rm, writeFile } from 'node:fs/promises';
import { gzipSync } from 'node:zlib';

import { DeltameshError } from '@deltamesh/decoder';
import { createEncoder } from '@deltamesh/encoder';
import { build } from 'esbuild';

import { EXAMPLES, makeExample } from './src/mesh/examples.js';
import { packOrder } from './src/mesh/prepared.js';
import { DEFAULTS, encodeOptions } from './src/settings.js';

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
await build({
  entryPoints: ['main', 'page', 'workers/read-worker', 'workers/codec-worker', 'workers/decode-worker', 'workers/map-worker', 'workers/pack-worker', 'workers/peers-worker'].map(
    (name) => new URL(`src/${name}.js`, here).pathname,
  ),
  outdir: dist.pathname,
  entryNames: '[name]',
  chunkNames: 'part-[hash]',
  splitting: true,
  bundle: true,
  minify: true,
  sourcemap: true,
  format: 'esm',
  target: 'es2022',
  external: ['node:*', 'fs', 'path', './text/*'], // of modules that run in node, too; texts of modules that are there as files
  logLevel: 'warning',
});
for (const name of ['index.html', 'style.css']) await copyFile(new URL(name, here), new URL(name, dist));
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

// The examples as streams, so that nobody waits for the encoder.
const encoder = await createEncoder();
for (const name of Object.keys(EXAMPLES)) {
  const encoded = encoder.encode(makeExample(name).mesh, encodeOptions(DEFAULTS));
  if (encoded instanceof DeltameshError) throw encoded;
  await writeFile(new URL(`${name}.dmsh`, dist), encoded.bytes);
  await writeFile(new URL(`${name}.order.gz`, dist), gzipSync(packOrder(encoded.order)));
}
