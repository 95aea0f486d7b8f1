// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Faults of the network, of streams, assets and modules: errors, and the next load works.
import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { after, before, test } from 'node:test';

import { hasChromium } from '../chromium.js';
import { LOADERS, openBrowser } from './setup.js';

const root = new URL('../../../', import.meta.url);
const skip = hasChromium ? false : 'Chromium is not installed (scripts/setup web)';
const SLOW_MILLISECONDS = 1500;
const MANY_LOADERS = 100;

/** What happens to a request; only what is slow arrives. */
const FAULTS = {
  503: (request) => request.respond({ status: 503, body: 'later' }),
  cut: (request) => request.abort('connectionreset'),
  slow: (request) => setTimeout(() => request.continue(), SLOW_MILLISECONDS),
  'of the wrong type': (request) => request.respond({ status: 200, contentType: 'text/html', body: '<!doctype html><p>Sign in' }),
};

function golden(name) {
  const folder = new URL('tests/golden/', root);
  return readFileSync(new URL(readdirSync(folder).find((file) => file.startsWith(`${name}.`) && file.endsWith('.dmsh')), folder));
}

let browser;
before(async () => {
  if (skip) return;
  const asset = readFileSync(new URL('gltf_ext/DELTAMESH_mesh_compression/samples/valid/cube.glb', root));
  browser = await openBrowser(new Map([['/good.dmsh', golden('attributes.compact')], ['/good.glb', asset]]));
});
after(() => browser?.close());

/** `fault` happens to what matches `pattern` until end() is called. */
async function disturb(page, pattern, fault) {
  let hits = 0;
  const listener = (request) => {
    if (!pattern.test(new URL(request.url()).pathname)) return request.continue();
    ++hits;
    return fault(request);
  };
  await page.setRequestInterception(true);
  page.on('request', listener);
  return async () => {
    page.off('request', listener);
    await page.setRequestInterception(false);
    return hits;
  };
}

const load = (page, url) => page.evaluate((url) => window.tryToLoad(url), url);

for (const loader of LOADERS) {
  for (const [name, fault] of Object.entries(FAULTS)) {
    test(`what is ${name} is an error in ${loader}, and the next load works`, { skip }, async () => {
      for (const pattern of [/good\.(dmsh|glb)$/, /\.wasm$|^\/(core|rare|highpass)-/]) {
        const { page, problems } = await browser.openPage(loader);
        const end = await disturb(page, pattern, fault);
        const outcomes = [await load(page, '/good.dmsh'), await load(page, '/good.glb')];
        assert.ok((await end()) > 0, `nothing asked for ${pattern}`);
        for (const outcome of outcomes) assert.equal(outcome === '', name === 'slow', `${pattern}: ${outcome}`);
        for (const url of ['/good.dmsh', '/good.glb']) assert.equal(await load(page, url), '', `${url} after ${pattern}`);
        assert.deepEqual(problems, []);
        await page.close();
      }
    });
  }

  test(`modules that are not there as files come from their texts in ${loader}`, { skip }, async () => {
    const { page, problems } = await browser.openPage(loader);
    const end = await disturb(page, /\.wasm$/, FAULTS['of the wrong type']);
    assert.equal(await load(page, '/good.dmsh'), '');
    assert.ok((await end()) > 0);
    assert.deepEqual(problems, []);
    await page.close();
  });
}

test('many loaders that nobody disposes of share workers and modules', { skip }, async () => {
  const { page, problems } = await browser.openPage('three');
  const asked = [];
  page.on('request', (request) => asked.push(new URL(request.url()).pathname));
  assert.deepEqual(await page.evaluate((count) => window.loadByMany(count, '/good.dmsh'), MANY_LOADERS), Array(MANY_LOADERS).fill(''));
  assert.ok(page.workers().length <= 4);
  for (const name of ['core', 'highpass', 'rare']) assert.equal(asked.filter((path) => path === `/${name}.wasm`).length, 1, name);
  assert.deepEqual(problems, []);
  await page.close();
});

test("Babylon.js draws a stream with the README's imports alone", { skip }, async () => {
  const { page, problems } = await browser.openPage('babylon-readme');
  assert.equal(await page.evaluate(() => window.drawStream('/good.dmsh')), true);
  assert.deepEqual(problems, []);
  await page.close();
});

test('a page that allows no worker from a text says what to give, and takes a worker of its own', { skip }, async () => {
  const { page } = await browser.openPage('three-strict');
  assert.match(await load(page, '/good.dmsh'), /createWorker/);
  assert.equal(await page.evaluate(() => window.loadByOwnWorker('/good.dmsh')), '');
  await page.close();
});
