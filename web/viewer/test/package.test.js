// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// What of the viewer is packed: the page with all that it needs, and its server.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { get } from 'node:http';
import { test } from 'node:test';

import { serve } from '../serve.js';
import { hasChromium } from './browser.js';

const MOST_BYTES = 2000000;

test('the package has the page, its workers, the modules and the server', (t) => {
  const folder = new URL('../', import.meta.url);
  const [{ files, size }] = JSON.parse(execFileSync('npm', ['pack', '--dry-run', '--json', '--ignore-scripts'], { cwd: folder, encoding: 'utf8' }));
  const modules = ['core', 'highpass', 'rare', 'grid', 'zstd', 'map', 'encoder', 'draco_encoder', 'draco_decoder'].map((name) => `dist/${name}.wasm`);
  const examples = ['room', 'knot', 'terrain'].flatMap((name) => [`dist/${name}.dmsh`, `dist/${name}.order.gz`]);
  const scripts = ['main', 'page', 'draco_wasm_wrapper', 'example-worker', 'read-worker', 'renderer-worker', 'codec-worker', 'decode-worker', 'live-worker', 'map-worker', 'pack-worker', 'peers-worker'].map((name) => `dist/${name}.js`);
  const stills = hasChromium ? ['dist/still-dark.webp', 'dist/still-light.webp'] : [];
  const own = ['LICENSE', 'README.md', 'dist/LICENSE', 'dist/NOTICE', 'dist/index.html', 'dist/style.css', 'dist/studio.gz', ...stills, 'bridge.js', 'package.json', 'serve.js'];
  const paths = files.map(({ path }) => path).filter((path) => !/^dist\/(part|read-mesh)-\w+\.js$/.test(path)); // what bundles share
  assert.deepEqual(paths.sort(), [...modules, ...examples, ...scripts, ...own].sort());
  t.diagnostic(`${size} bytes`);
  assert.ok(size <= MOST_BYTES);
});

const statusOf = (port, path) =>
  new Promise((resolve, reject) => get({ port, path, agent: false }, (response) => resolve(response.resume().statusCode)).on('error', reject));

test('the server answers requests for what it does not have', async () => {
  const server = await serve();
  for (const path of ['//', '/../serve.js', '/no.html', '/%', '//:0']) assert.equal(await statusOf(server.address().port, path), 404, path);
  server.closeAllConnections();
  server.close();
});
