// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Packed assets look as unpacked ones do, in three.js and in Babylon.js.
import assert from 'node:assert/strict';
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';

import { hasChromium } from '../chromium.js';
import { assets, hasCorpus, hasProgram } from './assets.js';
import { LOADERS, openBrowser } from './setup.js';

const MOST_DIFFERENT = 0.001;
const LEAST_COVERED = 0.01; // a picture without the asset has 0
/** Shares of an animation. */
const POSES = [0.4];

let skip = false;
if (!hasChromium) skip = 'Chromium is not installed (scripts/setup web)';
else if (!hasProgram) skip = 'the native program is not built';

const names = [];
const urls = (name) => [`/plain.${name}`, `/packed.${name}`];
let browser;
before(async () => {
  if (skip) return;
  const files = new Map();
  for (const { name, packed, plain } of assets()) {
    names.push(name);
    files.set(`/packed.${name}`, packed).set(`/plain.${name}`, plain);
  }
  browser = await openBrowser(files);
});
after(() => browser?.close());

/** `DELTAMESH_PICTURES` names a folder for pictures of the packed assets. */
async function keepPicture(page, name) {
  const folder = process.env.DELTAMESH_PICTURES;
  if (!folder) return;
  mkdirSync(folder, { recursive: true });
  await (await page.$('canvas')).screenshot({ path: join(folder, `${name}.png`) });
}

for (const loader of LOADERS) {
  test(`packed assets look as unpacked ones do in ${loader}`, { skip }, async (t) => {
    const { page, problems } = await browser.openPage(loader);
    if (!hasCorpus) t.diagnostic('there is no corpus: generated assets alone are compared');
    const compare = (plain, packed) => page.evaluate((...args) => window.compareAssets(...args), plain, packed, POSES);
    for (const name of names) {
      const views = await compare(...urls(name));
      const different = Math.max(...views.map((view) => view.different));
      const covered = Math.max(...views.map((view) => view.covered));
      t.diagnostic(`${name}: ${(100 * different).toFixed(3)} % of the pixels differ, the asset has up to ${(100 * covered).toFixed(0)} %`);
      await keepPicture(page, `${loader}.${name}`);
      assert.ok(covered >= LEAST_COVERED, `${name} is not seen`);
      assert.ok(different <= MOST_DIFFERENT, `${name}: ${different}`);
    }
    const others = await compare(urls(names[0])[0], urls(names[1])[1]);
    assert.ok(others.every(({ different }) => different > MOST_DIFFERENT), 'another asset looks different');
    assert.deepEqual(problems, []);
    await page.close();
  });
}
