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

import { makeExample } from '../src/mesh/examples.js';
import { writeGlb } from '../src/mesh/write-glb.js';
import { hasChromium, openPage, waitUntilDone } from './browser.js';
import { choose, countColors, countHoles, drop, longestTask, picture, textOf, watchTasks } from './use.js';

const root = fileURLToPath(new URL('../../../', import.meta.url));
const program = join(root, 'build/release/deltamesh');
const folder = join(root, 'build/web/map');
const LEAST_PARTS = 200;
const ROUNDS = 4; // of 50 replacements each
const REPLACEMENTS = 50;
const MOST_MILLISECONDS = 100;
const MOST_GROWTH = 4e6;
const MOST_RESIDENT_GROWTH = 64e6;
const BYTES_OF_VERTEX = 24;

let skip = hasChromium ? false : 'Chromium is not installed (scripts/setup web)';
if (!existsSync(program)) skip = 'the native program is not built';

const mesh = join(folder, 'terrain.ply');
function splitMesh() {
  execFileSync(program, ['map', 'split', mesh, join(folder, 'map'), '--part-edge', '54', '--effort', '0'], { stdio: 'ignore' });
}

let open;
let page;
before(async () => {
  if (skip) return;
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  execFileSync(program, ['generate', 'terrain', mesh, '--vertices', '60000'], { stdio: 'ignore' });
  splitMesh();
  open = await openPage({ hash: '#effort=0' });
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

/** Bytes of the page after what nothing needs is gone: of JavaScript with its arrays, and of all of the browser's processes. */
async function usedBytes() {
  const client = await page.createCDPSession();
  await client.send('HeapProfiler.collectGarbage');
  const { usedSize, backingStorageSize = 0 } = await client.send('Runtime.getHeapUsage');
  await client.detach();
  const browser = await page.browser().target().createCDPSession();
  const { processInfo } = await browser.send('SystemInfo.getProcessInfo');
  await browser.detach();
  const pages = (id) => Number(readFileSync(`/proc/${id}/statm`, 'utf8').split(' ')[1]);
  return { own: usedSize + backingStorageSize, resident: 4096 * processInfo.reduce((sum, { id }) => sum + pages(id), 0) };
}

/** Longest time between frames while the page's function `replaceOne` is called `count` times, each followed by a frame. */
function longestFrame(count) {
  return page.evaluate(async (count) => {
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
      await window.replaceOne();
      await new Promise(requestAnimationFrame);
    }
    goesOn = false;
    return longest;
  }, count);
}

test('parts are replaced one by one: same picture, no cracks, steady memory, no long frame', { skip }, async (t) => {
  const map = await openMap(manifest());
  const shown = map.parts.filter(({ isFinest }) => isFinest);
  assert.ok(shown.length >= LEAST_PARTS, `${shown.length} parts`);
  const contents = shown.map((part) => Buffer.from(bytesOf(part)).toString('base64'));
  // How long this machine takes to draw the map, with nothing replaced: the key shows all of it once more.
  await page.evaluate(() => {
    const canvas = document.querySelector('canvas');
    window.replaceOne = async () => canvas.dispatchEvent(new KeyboardEvent('keydown', { key: 'Home' }));
  });
  const drawing = await longestFrame(REPLACEMENTS);
  const before = await picture(page);
  assert.equal(await countHoles(page), 0);
  await page.evaluate((contents) => {
    const parts = contents.map((base64) => Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0)));
    let next = 0;
    window.replaceOne = () => {
      const place = next++ % parts.length;
      return window.viewer.replacePart(place, parts[place].slice().buffer);
    };
  }, contents);
  const rounds = [];
  for (let round = 0; round < ROUNDS; ++round) {
    await watchTasks(page);
    const frame = await longestFrame(REPLACEMENTS);
    const task = await longestTask(page);
    rounds.push({ frame, task, ...(await usedBytes()) });
    assert.equal(await countHoles(page), 0);
  }
  const task = Math.max(...rounds.map((round) => round.task));
  // Other programs may disturb a round; what replacing itself takes is in all of them.
  const frame = Math.min(...rounds.map((round) => round.frame));
  const megabytes = (of) => rounds.map((round) => (of(round) / 1e6).toFixed(1)).join(', ');
  t.diagnostic(`${shown.length} parts, ${ROUNDS * REPLACEMENTS} replacements, longest task ${task} ms`);
  t.diagnostic(`longest frame of each round ${rounds.map((round) => round.frame.toFixed(0)).join(', ')} ms; of drawing alone ${drawing.toFixed(0)} ms`);
  t.diagnostic(`MB after each round: of the page ${megabytes(({ own }) => own)}, resident ${megabytes(({ resident }) => resident)}`);
  assert.ok(rounds.at(-1).own - rounds[0].own < MOST_GROWTH);
  assert.ok(rounds.at(-1).resident - rounds[0].resident < MOST_RESIDENT_GROWTH);
  assert.ok(task <= MOST_MILLISECONDS, `${task} ms`);
  assert.ok(frame <= Math.max(MOST_MILLISECONDS, 2 * drawing), `${frame} ms, to draw ${drawing} ms`);
  assert.equal(await picture(page), before);
  assert.deepEqual(open.problems, []);
});

test('a folder that is opened again shows what changed, without cracks', { skip }, async () => {
  const before = await picture(page);
  const ply = readFileSync(mesh);
  const first = ply.indexOf('end_header\n') + 'end_header\n'.length;
  const count = Number(/element vertex (\d+)/.exec(ply.toString('latin1', 0, first))[1]);
  const row = (vertex) => first + BYTES_OF_VERTEX * vertex;
  const [x, y] = [0, 8].map((at) => ply.readDoubleLE(row(count >> 1) + at));
  for (let vertex = 0; vertex < count; ++vertex) {
    const [at, away] = [row(vertex), Math.hypot(ply.readDoubleLE(row(vertex)) - x, ply.readDoubleLE(row(vertex) + 8) - y)];
    ply.writeDoubleLE(ply.readDoubleLE(at + 16) + 60 * Math.exp(-((away / 40) ** 2)), at + 16);
  }
  writeFileSync(mesh, ply);
  splitMesh();
  await chooseFolder();
  assert.equal(await textOf(page, 'error'), '');
  assert.notEqual(await picture(page), before);
  assert.equal(await countHoles(page), 0);
});

/** Vertices inside become two each: corners to the right of them get one that is `share` of an edge away. */
function crack({ positions, indices, attributes: [color] }, share) {
  const count = positions.length / 3;
  const chosen = new Map();
  for (let at = 300; at < indices.length; at += 3000) chosen.set(indices[at], count + chosen.size);
  const copy = (values, change) => {
    const all = new values.constructor(values.length + 3 * chosen.size);
    all.set(values);
    for (const [vertex, own] of chosen) for (let c = 0; c < 3; ++c) all[3 * own + c] = values[3 * vertex + c] + (c === 0 ? change : 0);
    return all;
  };
  const x = (vertex) => positions[3 * vertex];
  for (let at = 0; at < indices.length; at += 3) {
    const corners = indices.subarray(at, at + 3);
    const middle = corners.reduce((sum, vertex) => sum + x(vertex) / 3, 0);
    corners.forEach((vertex, i) => {
      if (chosen.has(vertex) && middle > x(vertex)) corners[i] = chosen.get(vertex);
    });
  }
  const edge = Math.abs(x(1) - x(0));
  return { positions: copy(positions, share * edge), indices, attributes: [{ ...color, values: copy(color.values, 0) }] };
}

test('holes are seen, and cracks of a tenth of an edge', { skip }, async (t) => {
  const terrain = makeExample('terrain').mesh;
  const counts = [];
  for (const share of [0, 0.1, 0.3]) {
    const damaged = share > 0 ? crack(makeExample('terrain').mesh, share) : terrain;
    await drop(page, 'damaged.glb', writeGlb({ ...terrain, ...damaged }));
    await choose(page, 'view', 'original');
    await choose(page, 'up', 'z');
    counts.push(await countHoles(page));
  }
  for (let at = 0; at + 30 < terrain.indices.length; at += 900) terrain.indices.copyWithin(at + 6, at, at + 6);
  await drop(page, 'hole.glb', writeGlb(terrain));
  counts.push(await countHoles(page));
  t.diagnostic(`${counts.join(', ')} pixels`);
  assert.equal(counts[0], 0);
  assert.ok(counts[1] > 0 && counts[2] > counts[1] && counts[3] > counts[2]);
  await choose(page, 'view', 'side');
  await choose(page, 'up', 'file');
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
