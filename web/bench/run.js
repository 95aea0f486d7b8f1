// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Sizes of the modules, and memory and times of decoding beside Draco's module: node run.js [--quick] [FILE...]. See README.md.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { fileURLToPath } from 'node:url';
import { brotliCompressSync } from 'node:zlib';

import { DeltameshError, createDecoder } from '@deltamesh/decoder';
import { createEncoder } from '@deltamesh/encoder';
import createEncoderModule from 'draco3d/draco_encoder_nodejs.js';
import { buildSync } from 'esbuild';

import { hasChromium } from '../test/chromium.js';
import { encodeDraco } from './draco.js';
import { Chromium } from './in-chromium.js';
import { measureInNode } from './in-node.js';
import { inputs } from './inputs.js';
import { median } from './measure.js';

const require = createRequire(import.meta.url);
const FILES = {
  'core, JavaScript': '@deltamesh/decoder',
  core: '@deltamesh/decoder/core.wasm',
  highpass: '@deltamesh/decoder/highpass.wasm',
  zstd: '@deltamesh/decoder/zstd.wasm',
  rare: '@deltamesh/decoder/rare.wasm',
  grid: '@deltamesh/decoder/grid.wasm',
  draco: 'draco3d/draco_decoder.wasm',
  'draco, JavaScript': 'draco3d/draco_decoder_nodejs.js',
};
/** Lattices by the default bound, on the largest error; highpass by one on VDE, which it is for. */
const REQUESTS = {
  lattice: { geometry: 'predictive' },
  highpass: { geometry: 'highpass', vde: { value: 0.02, unit: 'diagonal' } },
};

const args = process.argv.slice(2);
const isQuick = args.includes('--quick');
const COLD_TURNS = isQuick ? 1 : 5;

/** Of @deltamesh/decoder what a bundler makes, without the texts of modules. */
function bundleOf(name) {
  const entryPoints = [fileURLToPath(import.meta.resolve(name))];
  return buildSync({ entryPoints, bundle: true, minify: true, write: false, format: 'esm', target: 'es2022', external: ['./text/*'] }).outputFiles[0].contents;
}

const fileOf = (name) => {
  const path = FILES[name];
  return path.startsWith('@') && !path.endsWith('.wasm') ? bundleOf(path) : readFileSync(require.resolve(path));
};
const bytesOf = (name) => new Uint8Array(fileOf(name));

function printSizes() {
  console.log('| file | bytes | after brotli |\n|---|---|---|');
  for (const name of Object.keys(FILES)) {
    const bytes = fileOf(name);
    console.log(`| ${name} | ${bytes.length} | ${brotliCompressSync(bytes).length} |`);
  }
}

function check(result) {
  if (result instanceof DeltameshError) throw result;
  return result;
}

/** Streams of all three codecs, positions at most as far off in Draco's as in the lattice's. */
async function streamsOf(meshes, encoder, decoder, draco) {
  const jobs = Object.fromEntries(
    Object.entries(REQUESTS).map(([name, request]) => [
      name,
      { codec: 'deltamesh', streams: meshes.map((mesh) => check(encoder.encode(mesh, { ...request, ...(isQuick && { effort: 0 }) })).bytes) },
    ]),
  );
  const errors = jobs.lattice.streams.map((bytes) => decoder.inspect(bytes).quality.maxError);
  jobs.draco = { codec: 'draco', streams: meshes.map((mesh, i) => encodeDraco(draco, mesh, errors[i])) };
  return jobs;
}

const geometricMean = (values) => Math.exp(values.reduce((sum, value) => sum + Math.log(value), 0) / values.length);
const rounded = (value) => value.toFixed(value < 10 ? 2 : 1);

/** By kind, as cold() has them, and by job. */
async function coldTimes(jobs, modules, measure) {
  const kinds = {};
  for (let turn = 0; turn < COLD_TURNS; ++turn)
    for (const [name, job] of Object.entries(jobs))
      for (const [kind, time] of Object.entries(await measure({ kind: 'cold', modules, ...job }))) ((kinds[kind] ??= {})[name] ??= []).push(time);
  const medians = (times) => Object.fromEntries(Object.entries(times).map(([name, values]) => [name, median(values)]));
  return Object.fromEntries(Object.entries(kinds).map(([kind, times]) => [kind, medians(times)]));
}

async function printTimes(where, measure, meshes, modules) {
  const ratios = {};
  const row = (cells) => console.log(`| ${cells.join(' | ')} |`);
  console.log(`\nIn ${where}: milliseconds, and times Draco's\n`);
  row(['mesh', 'KB of Draco, lattice, highpass', '', 'Draco', 'lattice', 'highpass']);
  console.log('|---|---|---|---|---|---|');
  for (const [mesh, jobs] of meshes) {
    const size = ({ streams }) => rounded(streams.reduce((sum, { length }) => sum + length, 0) / 1000);
    const sizes = [jobs.draco, jobs.lattice, jobs.highpass].map(size).join(', ');
    const all = { warm: await measure({ kind: 'warm', jobs, modules }), ...(await coldTimes(jobs, modules, measure)) };
    for (const [kind, times] of Object.entries(all)) {
      const cells = Object.keys(REQUESTS).map((name) => {
        const ratio = times[name] / times.draco;
        (ratios[`${kind} ${name}`] ??= []).push(ratio);
        return `${rounded(times[name])} (${rounded(ratio)})`;
      });
      row([mesh, sizes, kind, rounded(times.draco), ...cells]);
    }
  }
  for (const [name, values] of Object.entries(ratios))
    console.log(`${name}: geometric mean ${rounded(geometricMean(values))}, largest ${rounded(Math.max(...values))}`);
}

async function printMemory(meshes, modules) {
  const ratios = [];
  console.log("\nMemory of the modules after decoding, MiB, and times Draco's\n\n| mesh | Draco | lattice |\n|---|---|---|");
  for (const [mesh, { draco, lattice }] of meshes) {
    const [theirs, own] = [await measureInNode({ kind: 'memory', modules, ...draco }), await measureInNode({ kind: 'memory', modules, ...lattice })];
    ratios.push(own / theirs);
    console.log(`| ${mesh} | ${rounded(theirs)} | ${rounded(own)} (${rounded(own / theirs)}) |`);
  }
  console.log(`memory: geometric mean ${rounded(geometricMean(ratios))}, largest ${rounded(Math.max(...ratios))}`);
}

printSizes();
const encoder = await createEncoder();
const decoder = await createDecoder();
const draco = await createEncoderModule();
const meshes = new Map();
for await (const { name, meshes: parts } of inputs(args.filter((arg) => !arg.startsWith('--'))))
  meshes.set(name, await streamsOf(parts, encoder, decoder, draco));
const modules = Object.fromEntries(['core', 'highpass', 'rare', 'grid', 'zstd', 'draco'].map((name) => [name, bytesOf(name)]));
await printMemory(meshes, modules);
await printTimes(`node ${process.version}`, measureInNode, meshes, modules);
if (hasChromium && !args.includes('--node')) {
  const chromium = await new Chromium().open();
  await printTimes('Chromium', (message) => chromium.measure(message), meshes, modules);
  chromium.close();
} else {
  console.log('\nChromium is not installed or not asked for: nothing was measured there.');
}
