// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// One app by every bundler, without any, and by every runtime: the packages as npm packs them draw the same picture everywhere.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { pathToFileURL } from 'node:url';

import { hasChromium, launch } from '../chromium.js';
import { BUNDLERS, bundleForNode } from './bundlers.js';
import { serveFolders } from './serve.js';
import { fresh, prepare, work } from './workplace.js';

const LEAST_COVERED = 0.02;
const MOST_MILLISECONDS = 30000;
const skip = hasChromium ? false : 'Chromium is not installed (scripts/setup web)';
const MODULES = ['@deltamesh/three', '@deltamesh/decoder', '@deltamesh/decoder/pool', '@deltamesh/decoder/gltf', 'three', 'three/examples/jsm/loaders/GLTFLoader.js'];

let browser;
let expected;
before(async () => {
  if (skip) return;
  prepare();
  browser = await launch();
});
after(() => browser?.close());

/** The canvas' pixels, once the page says that they are drawn. */
async function pictureOf(url) {
  const page = await browser.newPage();
  const problems = [];
  page.on('pageerror', (error) => problems.push(String(error)));
  await page.goto(url);
  await page.waitForFunction(() => document.title.match(/^(drawn|failed)/) !== null, { timeout: MOST_MILLISECONDS }).catch(() => {});
  assert.equal(await page.title(), 'drawn', problems.join('\n'));
  const pixels = await page.evaluate(() => {
    const canvas = document.querySelector('canvas');
    const context = new OffscreenCanvas(canvas.width, canvas.height).getContext('2d');
    context.drawImage(canvas, 0, 0);
    return [...context.getImageData(0, 0, canvas.width, canvas.height).data];
  });
  const folder = process.env.DELTAMESH_PICTURES;
  if (folder) {
    mkdirSync(folder, { recursive: true });
    await (await page.$('canvas')).screenshot({ path: join(folder, `matrix.${Date.now()}.png`) });
  }
  await page.close();
  assert.deepEqual(problems, []);
  return pixels;
}

async function check(url) {
  const pixels = await pictureOf(url);
  const covered = pixels.filter((value, i) => i % 4 === 0 && value !== pixels[0]).length / (pixels.length / 4);
  assert.ok(covered >= LEAST_COVERED, `the picture has ${covered} that is not background`);
  expected ??= pixels;
  assert.ok(pixels.length === expected.length && pixels.every((value, i) => value === expected[i]), 'another picture than that of the first');
}

for (const [name, build] of Object.entries(BUNDLERS)) {
  test(name, { skip }, async () => {
    const { folder, origin, close } = await build();
    const server = origin ? { origin, close } : await serveFolders(folder, join(folder, '..'));
    try {
      await check(`${server.origin}/`);
      if (name !== 'Next') return;
      const page = await browser.newPage();
      await page.goto(`${server.origin}/server`);
      assert.match(await page.$eval('#count', (element) => element.textContent), /^[1-9]\d*$/);
      await page.close();
    } finally {
      await server.close();
    }
  });
}

/** A page of modules from `modules`, an origin, by an import map. */
function writePlainPage(folder, modules) {
  const files = (name) => {
    if (name === 'three') return 'three/build/three.module.js';
    if (name.startsWith('three/')) return name;
    const { exports } = JSON.parse(readFileSync(join(work, 'node_modules', name.split('/').slice(0, 2).join('/'), 'package.json')));
    const key = ['.', ...name.split('/').slice(2)].join('/');
    return join(name.split('/').slice(0, 2).join('/'), exports[key].default);
  };
  const imports = Object.fromEntries(MODULES.map((name) => [name, `${modules}/node_modules/${files(name)}`]));
  const html = readFileSync(join(folder, 'index.html'), 'utf8');
  writeFileSync(join(folder, 'index.html'), html.replace('<script', `<script type="importmap">${JSON.stringify({ imports })}</script>\n    <script`));
}

for (const isForeign of [false, true]) {
  test(isForeign ? 'modules of a second origin' : 'plain modules', { skip }, async () => {
    const folder = fresh(isForeign ? 'second-origin' : 'plain');
    const own = await serveFolders(folder, work);
    const other = await serveFolders(work);
    writePlainPage(folder, isForeign ? other.origin : '');
    try {
      await check(`${own.origin}/`);
    } finally {
      own.close();
      other.close();
    }
  });
}

test('one script on a disk', { skip }, async () => {
  const folder = fresh('file');
  writeFileSync(join(folder, 'deltamesh.js'), readFileSync(join(work, 'node_modules/@deltamesh/decoder/deltamesh.js')));
  writeFileSync(join(folder, 'stream.js'), `const STREAM = '${readFileSync(join(folder, 'stream.dmsh')).toString('base64')}';`);
  const pixels = await pictureOf(pathToFileURL(join(folder, 'file.html')).href);
  assert.ok(pixels.some((value, i) => i % 4 === 3 && value > 0));
});

const RUNTIMES = {
  'node, ES modules': [process.execPath, 'decode.mjs'],
  'node, require': [process.execPath, 'decode.cjs'],
  'esbuild, CommonJS': [process.execPath, 'bundled.cjs'],
  Deno: [join(work, 'node_modules/.bin/deno'), 'run', '--allow-all', '--node-modules-dir=manual', '--quiet', 'decode.mjs'],
  Bun: [join(work, 'node_modules/.bin/bun'), 'decode.mjs'],
};
for (const [name, [program, ...args]] of Object.entries(RUNTIMES)) {
  test(name, { skip }, async () => {
    const folder = fresh('runtime');
    if (args.includes('bundled.cjs')) await bundleForNode(folder);
    const [here, there] = execFileSync(program, args, { cwd: folder, encoding: 'utf8', timeout: MOST_MILLISECONDS }).trim().split(' ');
    assert.ok(Number(here) > 0);
    assert.equal(there, here);
  });
}
