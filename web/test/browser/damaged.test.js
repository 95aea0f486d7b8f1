// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Damaged streams and assets in a browser: errors, and the page goes on.
import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { after, before, test } from 'node:test';

import { hasChromium } from '../chromium.js';
import { LOADERS, openBrowser } from './setup.js';

const STREAMS = 300;
const ASSETS = 50;
const LEAST_REFUSED = 40; // of them
const MOST_MILLISECONDS = 20000;
const root = new URL('../../../', import.meta.url);
const skip = hasChromium ? false : 'Chromium is not installed (scripts/setup web)';

/** Numbers that look random, the same on every run. */
let state = 12345;
const upTo = (count) => Math.floor(((state = (Math.imul(state, 1664525) + 1013904223) >>> 0) / 2 ** 32) * count);

/** Some bytes differ, or the end is missing. */
function damage(bytes) {
  const damaged = new Uint8Array(bytes);
  if (upTo(4) === 0) return damaged.subarray(0, upTo(damaged.length));
  for (let left = 1 + upTo(4); left > 0; --left) damaged[upTo(damaged.length)] ^= 1 + upTo(255);
  return damaged;
}

function read(folder, ending) {
  const url = new URL(folder, root);
  return readdirSync(url).filter((name) => name.endsWith(ending)).map((name) => readFileSync(new URL(name, url)));
}

const files = new Map();
let browser;
before(async () => {
  if (skip) return;
  const [streams, assets] = [read('tests/golden/', '.dmsh'), read('gltf_ext/DELTAMESH_mesh_compression/samples/valid/', '.glb')];
  for (let i = 0; i < STREAMS; ++i) files.set(`/${i}.dmsh`, damage(streams[i % streams.length]));
  for (let i = 0; i < ASSETS; ++i) files.set(`/${i}.glb`, damage(assets[i % assets.length]));
  const good = new Map([['/good.dmsh', streams[0]], ['/good.glb', assets[0]]]);
  browser = await openBrowser(new Map([...files, ...good]));
});
after(() => browser?.close());

for (const loader of LOADERS) {
  test(`damaged streams and assets are errors in ${loader}, and the page goes on`, { skip }, async (t) => {
    const { page, problems } = await browser.openPage(loader);
    const outcomes = {};
    for (const url of files.keys()) {
      const attempt = page.evaluate((url) => window.tryToLoad(url), url);
      const limit = new Promise((resolve, reject) => setTimeout(reject, MOST_MILLISECONDS, new Error(`${url} takes too long`)).unref());
      const kind = `${url.split('.').pop()} ${(await Promise.race([attempt, limit])) === '' ? 'loaded' : 'refused'}`;
      outcomes[kind] = (outcomes[kind] ?? 0) + 1;
    }
    t.diagnostic(JSON.stringify(outcomes));
    // Streams have a checksum; of an asset a name or a number in its JSON may differ and load.
    assert.equal(outcomes['dmsh refused'], STREAMS);
    assert.ok(outcomes['glb refused'] >= LEAST_REFUSED);
    assert.equal(outcomes['glb refused'] + (outcomes['glb loaded'] ?? 0), ASSETS);
    for (const url of ['/good.dmsh', '/good.glb']) assert.equal(await page.evaluate((url) => window.tryToLoad(url), url), '');
    assert.deepEqual(problems, []);
    await page.close();
  });
}
