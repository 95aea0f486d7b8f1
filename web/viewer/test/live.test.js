// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// A map that changes in the page: from the publisher of examples/map_udp over loopback, and from servers that do what they should not.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { once } from 'node:events';
import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';

import { WebSocket, WebSocketServer } from 'ws';

import { hasChromium, openPage } from './browser.js';
import { countColors, countHoles, longestTask, picture, textOf, watchTasks } from './use.js';

const publisher = fileURLToPath(new URL('../../../build/release/tests/map_udp/map_udp_publisher', import.meta.url));
const SECONDS = 600; // a publisher's life; its map changes in the first half
let skip = hasChromium ? false : 'Chromium is not installed (scripts/setup web)';
if (!existsSync(publisher)) skip = 'the publisher of examples/map_udp is not built';

let running;
let port = 0;
async function publish() {
  running = spawn(publisher, [String(port), String(SECONDS)], { stdio: ['ignore', 'pipe', 'inherit'] });
  const [line] = await once(running.stdout, 'data');
  port = Number(line);
}

async function stopPublisher() {
  running.kill();
  await once(running, 'exit');
}

let open;
let page;
before(async () => {
  if (skip) return;
  await publish();
  open = await openPage({ hash: '?live=live&map=7', udpPort: port });
  ({ page } = open);
});
after(async () => {
  await open?.close();
  running?.kill();
});

const until = (page, id, text) =>
  page.waitForFunction((id, text) => new RegExp(text).test(document.getElementById(id).textContent), { timeout: 60000 }, id, text);

test('a map is shown as it changes, with its colours and without cracks, while the camera moves', { skip }, async (t) => {
  await until(page, 'mesh-name', '^Live map: 64 parts, 32,768 triangles$');
  await until(page, 'label-result', '^Changed \\d\\.\\d s ago$');
  await until(page, 'status', '^Live$');
  assert.match(await textOf(page, 'summary'), /^[\d.]+ [kM]B in [\d,]+ messages/);
  assert.ok((await countColors(page)) > 50);
  await page.addStyleTag({ content: '.pane-label { opacity: 0 }' }); // its letters have holes
  const first = await picture(page);
  await page.mouse.move(400, 400);
  await page.mouse.down();
  for (let turn = 1; turn <= 3; ++turn) {
    await page.mouse.move(400 + 40 * turn, 400);
    assert.equal(await countHoles(page), 0);
  }
  await watchTasks(page);
  for (let turn = 1; turn <= 20; ++turn) {
    await page.mouse.move(520 - 10 * turn, 400);
    await new Promise((resolve) => setTimeout(resolve, 100));
  }
  await page.mouse.up();
  t.diagnostic(`${await textOf(page, 'mesh-name')}; ${await textOf(page, 'label-result')}; ${await textOf(page, 'summary')}; longest task ${await longestTask(page)} ms`);
  await page.focus('#canvas');
  await page.keyboard.press('0');
  assert.notEqual(await picture(page), first);
  if (process.env.DELTAMESH_PICTURES) await page.screenshot({ path: join(process.env.DELTAMESH_PICTURES, 'live.png') });
  assert.deepEqual(open.problems, []);
});

test('a publisher that stops is said so, and another one goes on', { skip }, async () => {
  await stopPublisher();
  await until(page, 'error', '^no connection to ws://.*: trying again$');
  assert.match(await textOf(page, 'mesh-name'), /^Live map: 64 parts/);
  assert.ok((await countColors(page)) > 50);
  await publish();
  await until(page, 'status', '^Live$');
  await until(page, 'label-result', '^Changed \\d\\.\\d s ago$');
  assert.equal(await page.$eval('#error', (line) => line.hidden), true);
});

test('a mesh takes the place of the map', { skip }, async () => {
  await page.select('#example', 'terrain');
  await until(page, 'mesh-name', '^Terrain');
  await until(page, 'status', '^Done');
  await new Promise((resolve) => setTimeout(resolve, 500));
  assert.match(await textOf(page, 'mesh-name'), /^Terrain/);
  assert.equal(await page.$eval('#quality', (section) => section.hidden), false);
});

test('pages of other places get nothing from the bridge', { skip }, async () => {
  const [error] = await once(new WebSocket(`ws://localhost:${open.port}/live`, { origin: 'http://elsewhere.example' }), 'error');
  assert.match(error.message, /401/);
});

test('what is no message is refused, silence and no server are said', { skip }, async () => {
  const server = new WebSocketServer({ port: 0, host: '127.0.0.1' });
  await once(server, 'listening');
  let client;
  server.on('connection', (socket) => (client = socket));
  const other = await openPage({ hash: `?live=${encodeURIComponent(`ws://127.0.0.1:${server.address().port}`)}&map=12` });
  await until(other.page, 'error', 'says nothing of a map 12: ');
  for (const [message, what] of [[Buffer.from('DMAP'), 'a message was refused: '], ['hello', 'a text, where maps are bytes'], [Buffer.alloc(300000), '300000 bytes']]) {
    client.send(message);
    await until(other.page, 'error', what);
  }
  client.terminate();
  server.close();
  await until(other.page, 'error', 'no connection to ws://127.0.0.1');
  await other.close();
  for (const [query, what] of [['?live=ftp://x&map=1', 'not the address of a WebSocket'], ['?live=live&map=one', 'one is not the number of a map']]) {
    const odd = await openPage({ hash: query });
    await until(odd.page, 'error', what);
    await odd.close();
  }
});
