// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// A map in the page: opened from its folder, coloured, its parts replaced one by one.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';

import { DeltameshError } from '@deltamesh/decoder';
import { openMap } from '@deltamesh/decoder/map';

import { hasChromium, openPage, waitUntilDone } from './browser.js';
import { choose, countColors, longestTask, textOf, watchTasks } from './use.js';

const root = fileURLToPath(new URL('../../../', import.meta.url));
const program = join(root, 'build/release/deltamesh');
const folder = join(root, 'build/web/map');
const REPLACEMENTS = 200;
const MOST_MILLISECONDS = 100;
const MOST_GROWTH = 16e6;

let skip = hasChromium ? false : 'Chromium is not installed (scripts/setup web)';
if (!existsSync(program)) skip = 'the native program is not built';

let open;
let page;
before(async () => {
  if (skip) return;
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  execFileSync(program, ['generate', 'rooms', join(folder, 'rooms.ply'), '--vertices', '60000'], { stdio: 'ignore' });
  execFileSync(program, ['map', 'split', join(folder, 'rooms.ply'), join(folder, 'map'), '--part-edge', '1', '--effort', '0'], { stdio: 'ignore' });
  open = await openPage();
  ({ page } = open);
  await waitUntilDone(page);
});
after(() => open?.close());

const manifest = () => new Uint8Array(readFileSync(join(folder, 'map/map.dmm')));
const bytesOf = ({ file }) => new Uint8Array(readFileSync(join(folder, 'map', file)));

test('parts are decoded, and damaged ones are errors', { skip }, async () => {
  const map = await openMap(manifest());
  assert.ok(!(map instanceof DeltameshError), String(map));
  for (const [number, part] of map.parts.entries()) {
    const bytes = bytesOf(part);
    const mesh = map.decode(number, bytes);
    assert.ok(!(mesh instanceof DeltameshError), String(mesh));
    assert.equal(mesh.vertexCount, part.vertexCount);
    assert.equal(mesh.indices.length, 3 * part.triangleCount);
    bytes[bytes.length >> 1] ^= 1;
    assert.ok(map.decode(number, bytes) instanceof DeltameshError);
  }
  assert.ok((await openMap(manifest().subarray(0, 50))) instanceof DeltameshError);
});

/** The folder, as if it were chosen. */
async function chooseFolder() {
  const files = ['map.dmm', ...readdirSync(join(folder, 'map/parts')).map((name) => `parts/${name}`)];
  const contents = files.map((name) => [name, readFileSync(join(folder, 'map', name)).toString('base64')]);
  await page.evaluate((contents) => {
    const transfer = new DataTransfer();
    for (const [name, base64] of contents)
      transfer.items.add(new File([Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0))], name.split('/').pop()));
    document.body.dataset.state = 'busy';
    const input = document.getElementById('folder');
    input.files = transfer.files;
    input.dispatchEvent(new Event('change'));
  }, contents);
  await waitUntilDone(page);
}

test('a folder is opened, its parts are coloured', { skip }, async (t) => {
  await chooseFolder();
  assert.equal(await textOf(page, 'error'), '');
  t.diagnostic(await textOf(page, 'mesh-name'));
  assert.match(await textOf(page, 'mesh-name'), /^Map: \d+ parts/);
  for (const color of ['own', 'bytes', 'error']) {
    await choose(page, 'mapColor', color);
    assert.ok((await countColors(page)) > 50, color);
    assert.equal(await page.$eval('#scale', (scale) => scale.hidden), color === 'own');
    if (process.env.DELTAMESH_PICTURES) await page.screenshot({ path: join(process.env.DELTAMESH_PICTURES, `map.${color}.png`) });
  }
  await choose(page, 'mapColor', 'own');
});

async function usedBytes() {
  const client = await page.createCDPSession();
  await client.send('HeapProfiler.collectGarbage');
  const { usedSize } = await client.send('Runtime.getHeapUsage');
  const { buffers } = await page.evaluate(() => ({ buffers: performance.memory?.usedJSHeapSize ?? 0 }));
  await client.detach();
  return usedSize + buffers;
}

async function picture() {
  await page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))));
  return (await page.$('#canvas')).screenshot({ encoding: 'base64' });
}

test('parts are replaced one by one: same picture, steady memory, no long frame', { skip }, async (t) => {
  const map = await openMap(manifest());
  const shown = map.parts.filter(({ isFinest }) => isFinest);
  const contents = shown.map((part) => Buffer.from(bytesOf(part)).toString('base64'));
  await page.evaluate((contents) => {
    window.contents = contents.map((base64) => Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0)));
    /** `count` replacements, each followed by a frame. Longest time between frames. */
    window.replaceAll = async (count) => {
      let longest = 0;
      let last = performance.now();
      let goesOn = true;
      const watch = (now) => {
        longest = Math.max(longest, now - last);
        last = now;
        if (goesOn) requestAnimationFrame(watch);
      };
      requestAnimationFrame(watch);
      for (let i = 0; i < count; ++i) {
        const place = i % window.contents.length;
        await window.viewer.replacePart(place, window.contents[place].slice().buffer);
        await new Promise(requestAnimationFrame);
      }
      goesOn = false;
      return longest;
    };
  }, contents);
  const before = await picture();
  await page.evaluate(() => window.replaceAll(20));
  const first = await usedBytes();
  await watchTasks(page);
  const frame = await page.evaluate((count) => window.replaceAll(count), REPLACEMENTS);
  const [task, last] = [await longestTask(page), await usedBytes()];
  t.diagnostic(`${shown.length} parts, ${REPLACEMENTS} replacements: ${((last - first) / 1e6).toFixed(1)} MB more, longest task ${task} ms, longest frame ${frame.toFixed(0)} ms`);
  assert.ok(last - first < MOST_GROWTH);
  assert.ok(task <= MOST_MILLISECONDS, `${task} ms`);
  assert.equal(await picture(), before);
  assert.deepEqual(open.problems, []);
});

test('a folder without a map is said so, and a mesh is opened again', { skip }, async () => {
  await page.evaluate(() => {
    const transfer = new DataTransfer();
    transfer.items.add(new File(['x'], 'letter.txt'));
    document.body.dataset.state = 'busy';
    const input = document.getElementById('folder');
    input.files = transfer.files;
    input.dispatchEvent(new Event('change'));
  });
  await waitUntilDone(page);
  assert.match(await textOf(page, 'error'), /no map.dmm/);
  await page.select('#example', 'terrain');
  await page.waitForFunction(() => document.getElementById('mesh-name').textContent.startsWith('Terrain'));
  await waitUntilDone(page);
  assert.ok((await countColors(page)) > 50);
  assert.equal(await page.$eval('#quality', (section) => section.hidden), false);
});
