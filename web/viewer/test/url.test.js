// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Meshes of other places: by the page's address and by one that is pasted.
import assert from 'node:assert/strict';
import { createServer } from 'node:http';
import { test } from 'node:test';

import { makeExample } from '../src/mesh/examples.js';
import { writeGlb } from '../src/mesh/write-glb.js';
import { hasChromium, openPage, waitUntilDone } from './browser.js';
import { textOf } from './use.js';

const skip = hasChromium ? false : 'Chromium is not installed (scripts/setup web)';

test('a mesh of another place is opened by ?url=, and by a pasted address; what is not there is said', { skip }, async () => {
  const good = new Map([['/hill.glb', writeGlb(makeExample('terrain').mesh)]]);
  const server = createServer(({ url }, response) => {
    response.writeHead(good.has(url) ? 200 : 404, { 'access-control-allow-origin': '*' }).end(good.get(url));
  });
  await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve));
  const origin = `http://127.0.0.1:${server.address().port}`;
  const linked = await openPage({ hash: `?url=${encodeURIComponent(`${origin}/hill.glb`)}#effort=0` });
  await waitUntilDone(linked.page);
  assert.match(await textOf(linked.page, 'mesh-name'), /^hill.glb: 32,761 vertices/);
  const paste = (text) =>
    linked.page.evaluate((text) => {
      const clipboardData = new DataTransfer();
      clipboardData.setData('text/plain', text);
      document.body.dataset.state = 'busy';
      document.body.dispatchEvent(new ClipboardEvent('paste', { clipboardData, bubbles: true }));
    }, text);
  await paste(`${origin}/no.ply`);
  await waitUntilDone(linked.page);
  assert.match(await textOf(linked.page, 'error'), /no\.ply could not be fetched: 404/);
  await linked.page.select('#example', 'terrain');
  await linked.page.waitForFunction(() => document.getElementById('mesh-name').textContent.startsWith('Terrain'));
  await paste(`${origin}/hill.glb`);
  await waitUntilDone(linked.page);
  assert.match(await textOf(linked.page, 'mesh-name'), /^hill.glb/);
  await linked.close();
  good.set('/odd.ply', 'no mesh');
  for (const [path, what] of [['no.ply', /no\.ply could not be fetched: 404/], ['odd.ply', /odd\.ply/]]) {
    const failed = await openPage({ hash: `?url=${encodeURIComponent(`${origin}/${path}`)}#effort=0&example=terrain` });
    await failed.page.waitForFunction(() => document.getElementById('mesh-name').textContent.startsWith('Terrain'), { timeout: 60000 });
    await waitUntilDone(failed.page);
    assert.match(await textOf(failed.page, 'error'), what);
    assert.equal(await failed.page.$eval('#error', (line) => line.hidden), false);
    await failed.page.select('#example', 'knot');
    await failed.page.waitForFunction(() => document.getElementById('error').hidden);
    await failed.close();
  }
  server.closeAllConnections();
  server.close();
});
