// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// The pictures of the project's README, by the page itself. See README.md.
import { mkdirSync, readdirSync, statSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

import { frameOf } from '../src/mesh/display.js';
import { makeExample } from '../src/mesh/examples.js';
import { openPage, waitUntilDone } from '../test/browser.js';
import { choose, drop, picture, textOf } from '../test/use.js';
import { cutMap } from './cut-map.js';
import { drawCurve, pointsOf } from './curve.js';

const root = new URL('../../../', import.meta.url);
const folder = new URL('docs/pictures/', root);
const MOST_BYTES = 400000;
const THEMES = ['light', 'dark'];

async function settled(page) {
  await waitUntilDone(page);
  await new Promise((resolve) => setTimeout(resolve, 1500));
}

async function pageIn(theme) {
  const { page, close } = await openPage({ dark: theme === 'dark', width: 1200, height: 720 });
  await settled(page);
  await page.screenshot({ path: fileURLToPath(new URL(`page-${theme}.webp`, folder)), type: 'webp', quality: 80 });
  await close();
}

/** The map before and after, and how far the result is off, side by side. */
async function mapIn(theme, ply) {
  const { page, close } = await openPage({ dark: theme === 'dark', hash: '#example=terrain&effort=0&view=original&preset=small', width: 1100, height: 760 });
  await settled(page);
  await drop(page, 'map.ply', ply);
  await page.focus('#canvas');
  for (const key of ['ArrowUp', 'ArrowUp', '+']) await page.keyboard.press(key);
  await page.$eval('#canvas', (canvas) => canvas.blur()); // the mark of focus is not the map's
  await page.addStyleTag({ content: '#stage > :not(canvas) { visibility: hidden }' });
  const panes = [];
  for (const [view, color] of [['original', 'none'], ['result', 'none'], ['result', 'signed']]) {
    await choose(page, 'view', view);
    await choose(page, 'color', color);
    panes.push(await picture(page));
  }
  const [before, after] = [await textOf(page, 'label-original'), await textOf(page, 'label-result')];
  const captions = [before, after, 'Where it is off: red outward, blue inward'];
  await page.evaluate((panes, captions) => {
    const figure = (png, text) => `<figure><img src="data:image/png;base64,${png}"><figcaption>${text}</figcaption></figure>`;
    document.body.innerHTML = `<div id="row">${panes.map((png, i) => figure(png, captions[i])).join('')}</div>`;
    const style = document.createElement('style');
    style.textContent = `body { height: auto; background: var(--stage) } #row { display: flex; gap: 0; width: 1200px; padding: 6px }
      figure { flex: 1; margin: 0; text-align: center } img { width: 100%; height: 300px; object-fit: cover } figcaption { padding: 6px; font-size: 17px }`;
    document.head.append(style);
  }, panes, captions);
  await page.setViewport({ width: 1212, height: 500, deviceScaleFactor: 1 });
  await (await page.$('#row')).screenshot({ path: fileURLToPath(new URL(`map-${theme}.webp`, folder)), type: 'webp', quality: 80 });
  await close();
}

mkdirSync(folder, { recursive: true });
const ply = cutMap(fileURLToPath(new URL('build/release/deltamesh', root)));
for (const theme of THEMES) {
  await pageIn(theme);
  await mapIn(theme, ply);
}
const { mesh } = makeExample('knot');
writeFileSync(new URL('curve.svg', folder), drawCurve(await pointsOf(mesh, frameOf(mesh).diagonal), 'a knot of 33,280 vertices'));
const sizes = readdirSync(folder).map((name) => [name, statSync(new URL(name, folder)).size]);
console.log(sizes.map(([name, size]) => `${name}: ${size} bytes`).join('\n'));
if (sizes.reduce((sum, [, size]) => sum + size, 0) > MOST_BYTES) throw new Error(`more than ${MOST_BYTES} bytes`);
