// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// How each bundler builds the app, as its users would have it: without options for these packages.
import { execFileSync, spawn } from 'node:child_process';
import { cpSync, mkdirSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';

import { apps, fresh, streams, work } from './workplace.js';

const require = createRequire(join(work, 'package.json'));
const load = async (name) => import(pathToFileURL(require.resolve(name)));
const page = (script) => `<!doctype html><title>loading</title><link rel="icon" href="data:,"><body><script ${script}></script>`;

async function viteBuild(name) {
  const folder = fresh(`${name}-build`);
  const { build } = await load(name);
  await build({ root: folder, logLevel: 'error', configFile: false });
  return { folder: join(folder, 'dist') };
}

/** Its dev server, which bundles dependencies in its own way. */
async function viteServe(name) {
  const folder = fresh(`${name}-dev`);
  const { createServer } = await load(name);
  const server = await createServer({ root: folder, logLevel: 'error', configFile: false, cacheDir: join(folder, '.vite'), server: { port: 0, host: '127.0.0.1' } });
  await server.listen();
  return { origin: `http://127.0.0.1:${server.httpServer.address().port}`, close: () => server.close() };
}

async function webpack() {
  const folder = fresh('webpack');
  const { default: run } = await load('webpack');
  const compiler = run({ mode: 'production', context: folder, entry: './main.js', output: { path: join(folder, 'dist') }, performance: false });
  await new Promise((resolve, reject) =>
    compiler.run((error, stats) => (error || stats.hasErrors() ? reject(error ?? new Error(stats.toString())) : resolve())),
  );
  writeFileSync(join(folder, 'dist/index.html'), page('src="main.js" defer'));
  return { folder: join(folder, 'dist') };
}

async function esbuild(format) {
  const folder = fresh(`esbuild-${format}`);
  const { build } = await load('esbuild');
  await build({
    entryPoints: [join(folder, 'main.js')],
    bundle: true,
    minify: true,
    format,
    splitting: format === 'esm',
    outdir: join(folder, 'dist'),
    logLevel: 'error',
  });
  writeFileSync(join(folder, 'dist/index.html'), page(format === 'esm' ? 'type="module" src="main.js"' : 'src="main.js" defer'));
  return { folder: join(folder, 'dist') };
}

/** decode.cjs with all that it requires, for node. */
export async function bundleForNode(folder) {
  const { build } = await load('esbuild');
  await build({ entryPoints: [join(folder, 'decode.cjs')], bundle: true, platform: 'node', format: 'cjs', outfile: join(folder, 'bundled.cjs'), logLevel: 'error' });
}

async function rollup() {
  const folder = fresh('rollup');
  const { rollup: bundle } = await load('rollup');
  const { default: nodeResolve } = await load('@rollup/plugin-node-resolve');
  const built = await bundle({ input: join(folder, 'main.js'), plugins: [nodeResolve({ browser: true })], logLevel: 'silent' });
  await built.write({ dir: join(folder, 'dist'), format: 'es' });
  await built.close();
  writeFileSync(join(folder, 'dist/index.html'), page('type="module" src="main.js"'));
  return { folder: join(folder, 'dist') };
}

function run(command, args, cwd) {
  execFileSync(process.execPath, [require.resolve(command), ...args], { cwd, stdio: ['ignore', 'pipe', 'pipe'], env: { ...process.env, NEXT_TELEMETRY_DISABLED: '1' } });
}

function parcel() {
  const folder = fresh('parcel');
  run('parcel/lib/bin.js', ['build', 'index.html', '--no-cache', '--no-source-maps', '--dist-dir', 'dist'], folder);
  return { folder: join(folder, 'dist') };
}

async function next() {
  const folder = fresh('next');
  cpSync(join(apps, 'next'), folder, { recursive: true });
  mkdirSync(join(folder, 'public'));
  for (const name of streams) cpSync(join(folder, name), join(folder, 'public', name));
  rmSync(join(folder, 'main.js'));
  run('next/dist/bin/next', ['build'], folder);
  const port = 20000 + Math.floor(Math.random() * 20000);
  const server = spawn(process.execPath, [require.resolve('next/dist/bin/next'), 'start', '--port', String(port)], { cwd: folder, stdio: ['ignore', 'pipe', 'inherit'] });
  await new Promise((resolve, reject) => {
    server.stdout.on('data', (text) => String(text).includes('Ready') && resolve());
    server.on('exit', (code) => reject(new Error(`next start ended with ${code}`)));
  });
  return { origin: `http://127.0.0.1:${port}`, close: () => server.kill() };
}

/** Each builds, and returns { folder } to serve, or { origin, close } of its own server. */
export const BUNDLERS = {
  'Vite 6': () => viteBuild('vite6'),
  'Vite 6, dev server': () => viteServe('vite6'),
  'Vite 8': () => viteBuild('vite8'),
  'Vite 8, dev server': () => viteServe('vite8'),
  'webpack 5': webpack,
  'esbuild, ES modules': () => esbuild('esm'),
  'esbuild, one script': () => esbuild('iife'),
  Rollup: rollup,
  Parcel: parcel,
  Next: next,
};
