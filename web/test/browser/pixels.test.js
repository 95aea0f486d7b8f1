// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Packed assets look as unpacked ones do, in three.js and in Babylon.js.
import assert from 'node:assert/strict';
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';

import { hasChromium } from '../chromium.js';
import { assets, hasProgram } from './assets.js';
import { LOADERS, openBrowser } from './setup.js';

const MOST_DIFFERENT = 0.001;
const LEAST_COLORS = 20; // a picture without the asset has one

let skip = false;
if (!hasChromium) skip = 'Chromium is not installed (scripts/setup web)';
else if (!hasProgram) skip = 'the native program is not built';

const names = [];
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
    for (const name of names) {
      const { share, colors } = await page.evaluate((plain, packed) => window.compareAssets(plain, packed), `/plain.${name}`, `/packed.${name}`);
      t.diagnostic(`${name}: ${(100 * share).toFixed(3)} % of the pixels differ, ${colors} colours`);
      await keepPicture(page, `${loader}.${name}`);
      assert.ok(colors >= LEAST_COLORS, `${name} is not seen`);
      assert.ok(share <= MOST_DIFFERENT, `${name}: ${share}`);
    }
    assert.deepEqual(problems, []);
    await page.close();
  });
}
