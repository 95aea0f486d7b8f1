// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// The page as a person uses it.
import assert from 'node:assert/strict';
import { readFileSync, readdirSync, statSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';

import { DeltameshError, createDecoder } from '@deltamesh/decoder';

import { makeExample } from '../src/mesh/examples.js';
import { writeGlb } from '../src/mesh/write-glb.js';
import { hasChromium, openPage, waitUntilDone } from './browser.js';
import { choose, countColors, drop, picture, shownBytes, slide, textOf } from './use.js';

const skip = hasChromium ? false : 'Chromium is not installed (scripts/setup web)';

let open;
let page;
before(async () => {
  if (!hasChromium) return;
  open = await openPage({ hash: '#example=knot&view=side' });
  ({ page } = open);
  await waitUntilDone(page);
});
after(() => open?.close());

async function downloaded(selector, ending) {
  const known = new Set(readdirSync(open.downloads));
  await page.$eval(selector, (element) => element.click());
  for (let attempt = 0; attempt < 300; ++attempt) {
    const name = readdirSync(open.downloads).find((file) => !known.has(file) && file.endsWith(ending));
    if (name) return join(open.downloads, name);
    await new Promise((resolve) => setTimeout(resolve, 100));
  }
  throw new Error(`no ${ending} was downloaded`);
}

test('an example is there at once, on both sides', { skip }, async () => {
  assert.match(await textOf(page, 'mesh-name'), /Knot: 33,280 vertices/);
  for (const [from, to] of [[0.05, 0.45], [0.55, 0.95]]) assert.ok((await countColors(page, from, to)) > 50);
});

test('the bytes that are shown are those that are downloaded, and decode', { skip }, async () => {
  const file = await downloaded('#download', '.dmsh');
  assert.equal(statSync(file).size, await shownBytes(page));
  const decoder = await createDecoder();
  const mesh = await decoder.decode(new Uint8Array(readFileSync(file)));
  assert.ok(!(mesh instanceof DeltameshError));
  assert.equal(mesh.triangleCount, 66560);
});

test('GLB is downloaded', { skip }, async () => {
  const glb = readFileSync(await downloaded('#download-glb', '.glb'));
  assert.equal(glb.toString('latin1', 0, 4), 'glTF');
  assert.equal(glb.readUInt32LE(8), glb.length);
});

/** A GLB file whose JSON is changed. */
function withJson(glb, change) {
  const size = glb.readUInt32LE(12);
  const json = JSON.parse(glb.toString('utf8', 20, 20 + size));
  change(json);
  const text = Buffer.from(JSON.stringify(json));
  const padded = Buffer.concat([text, Buffer.alloc((4 - (text.length % 4)) % 4, 0x20)]);
  const head = Buffer.from(glb.subarray(0, 20));
  head.writeUInt32LE(20 + padded.length + glb.length - 20 - size, 8);
  head.writeUInt32LE(padded.length, 12);
  return Buffer.concat([head, padded, glb.subarray(20 + size)]);
}

test('a GLB file is downloaded with its meshes packed and all else as it was', { skip }, async () => {
  const { mesh } = makeExample('knot');
  const glb = withJson(Buffer.from(writeGlb(mesh)), (json) => {
    json.materials = [{ name: 'gold', pbrMetallicRoughness: { metallicFactor: 1 }, extensions: { KHR_materials_clearcoat: { clearcoatFactor: 1 } } }];
    json.extensionsUsed = ['KHR_materials_clearcoat'];
    json.meshes[0].primitives[0].material = 0;
  });
  await drop(page, 'gold.glb', glb);
  const packed = readFileSync(await downloaded('#download-packed', '.packed.glb'));
  assert.ok(packed.length < glb.length / 10, `${packed.length}`);
  withJson(packed, ({ materials, extensionsUsed, extensionsRequired, meshes }) => {
    assert.equal(materials[0].name, 'gold');
    assert.equal(materials[0].extensions.KHR_materials_clearcoat.clearcoatFactor, 1);
    assert.deepEqual(extensionsUsed.toSorted(), ['DELTAMESH_mesh_compression', 'KHR_materials_clearcoat']);
    assert.deepEqual(extensionsRequired, ['DELTAMESH_mesh_compression']);
    assert.ok(meshes[0].primitives[0].extensions.DELTAMESH_mesh_compression);
  });
  assert.match(await textOf(page, 'status'), /^Packed: .* kB, materials/);
  await page.select('#example', 'knot');
  await page.waitForFunction(() => document.getElementById('mesh-name').textContent.startsWith('Knot'));
  await waitUntilDone(page);
});

test('sliders change the bytes', { skip }, async () => {
  const before = await shownBytes(page);
  await slide(page, 'maxError', [110, 112, 115, 120, 126, 131, 135]);
  const coarse = await shownBytes(page);
  await slide(page, 'maxError', [130, 100, 80, 60]);
  const fine = await shownBytes(page);
  assert.ok(coarse < before && before < fine, `${coarse}, ${before}, ${fine}`);
});

test('a size in bytes is kept', { skip }, async () => {
  await page.$eval('#maxError-on', (check) => check.click());
  await slide(page, 'size', [70]);
  const most = await page.$eval('#size', (input) => Number(input.value));
  assert.ok((await shownBytes(page)) <= most);
  await page.$eval('#size-on', (check) => check.click());
  await page.$eval('#maxError-on', (check) => check.click());
  await slide(page, 'maxError', [115]);
});

test('what people ask for becomes smaller and smaller, or exact, and a headline says so', { skip }, async () => {
  const sizes = {};
  for (const preset of ['same', 'small', 'tiny', 'exact']) {
    await page.evaluate(() => (document.body.dataset.state = 'busy'));
    await choose(page, 'preset', preset);
    await waitUntilDone(page);
    sizes[preset] = await shownBytes(page);
    assert.match(await textOf(page, 'headline'), /^1.2 MB → \d+(\.\d+)? kB, and /);
    assert.match(page.url(), preset === 'same' ? /knot&view=side$/ : new RegExp(`preset=${preset}`));
  }
  assert.ok(sizes.tiny < sizes.small && sizes.small < sizes.same && sizes.same < sizes.exact, JSON.stringify(sizes));
  assert.match(await textOf(page, 'errors'), /Largest00 %/);
  await choose(page, 'preset', 'same');
  await slide(page, 'maxError', [115]);
  assert.equal(await page.$eval('input[name="preset"][value="own"]', (input) => input.checked), true);
  assert.match(await textOf(page, 'headline'), /times smaller$/);
});

test('views, shadings and heat maps draw', { skip }, async () => {
  for (const view of ['split', 'original', 'result', 'side']) {
    await choose(page, 'view', view);
    assert.ok((await countColors(page)) > 50, view);
  }
  const smooth = await countColors(page);
  await choose(page, 'shading', 'wire');
  await page.waitForSelector('#stage[data-wires="original result"]');
  assert.notEqual(await countColors(page), smooth);
  await choose(page, 'shading', 'flat');
  for (const color of ['signed', 'vde', 'normal']) {
    await choose(page, 'color', color);
    assert.ok((await countColors(page, 0.55, 0.95)) > 50, color);
    assert.equal(await page.$eval('#scale', (scale) => scale.hidden), false);
    assert.match(await textOf(page, 'scale-high'), /\d/);
  }
  await choose(page, 'color', 'none');
  await choose(page, 'shading', 'smooth');
});

test('the split moves by keys', { skip }, async () => {
  await choose(page, 'view', 'split');
  await page.focus('#divider');
  await page.keyboard.press('ArrowRight');
  assert.equal(await page.$eval('#divider', (divider) => divider.getAttribute('aria-valuenow')), '52');
  await choose(page, 'view', 'side');
});

test('others are computed beside', { skip }, async () => {
  await page.waitForFunction(() => document.querySelectorAll('#peers tbody tr').length === 4, { timeout: 60000 });
  const sizes = await page.$$eval('#peers tbody td:nth-child(2)', (cells) => cells.map((cell) => cell.textContent));
  const [own, draco, meshopt, deflated] = sizes.map((text) => Number(text.replaceAll(/\D/g, '')));
  assert.ok(own < draco && draco < deflated && deflated <= meshopt, sizes.join());
  assert.ok((await page.$$('#chart circle')).length >= 7);
  assert.equal((await page.$$('#chart circle[r="6"]')).length, 1);
});

test('all is done by keys: a mesh is compressed, turned and coloured', { skip }, async () => {
  await page.focus('#example');
  await page.keyboard.type('Terrain');
  await page.waitForFunction(() => document.getElementById('mesh-name').textContent.startsWith('Terrain'));
  await waitUntilDone(page);
  const reach = async (matches) => {
    for (let i = 0; i < 60; ++i) {
      if (await page.evaluate((selector) => document.activeElement.matches(selector), matches)) return;
      await page.keyboard.press('Tab');
    }
    assert.fail(`${matches} is not reached`);
  };
  await reach('#canvas');
  const seen = await picture(page);
  await page.keyboard.press('ArrowLeft');
  assert.notEqual(await picture(page), seen);
  await reach('input[name="view"]');
  await page.keyboard.press('ArrowRight');
  assert.equal(await page.$eval('#stage', (stage) => stage.dataset.view), 'split');
  await page.keyboard.press('ArrowLeft');
  await reach('input[name="color"]');
  await page.keyboard.press('ArrowRight');
  assert.equal(await page.$eval('#scale', (scale) => scale.hidden), false);
  await page.keyboard.press('ArrowLeft');
  const before = await shownBytes(page);
  await reach('#details > summary');
  await page.keyboard.press('Enter');
  await reach('#maxError-slider');
  for (let i = 0; i < 20; ++i) await page.keyboard.press('ArrowRight');
  const isSmaller = (before) => Number(document.querySelector('#bytes tbody tr:last-child td').textContent.replaceAll(/\D/g, '')) < before;
  await page.waitForFunction(isSmaller, { timeout: 120000 }, before);
  await waitUntilDone(page);
  await reach('#download');
  await reach('#copy-link');
});

test('every input has a name', { skip }, async () => {
  const nameless = await page.$$eval('input, select, button, a.button', (elements) =>
    elements.filter((e) => !(e.labels?.length || e.getAttribute('aria-label') || e.textContent.trim())).map((e) => e.outerHTML),
  );
  assert.deepEqual(nameless, []);
});

test('nothing went wrong on the console', { skip }, () => assert.deepEqual(open.problems, []));

test('a room is seen first, in its materials, split', { skip }, async () => {
  const first = await openPage();
  await waitUntilDone(first.page);
  assert.match(await textOf(first.page, 'headline'), /^1\.\d+ MB → \d\d(\.\d)? kB, and you cannot see it$/);
  assert.equal(await first.page.$eval('#divider', (divider) => divider.hidden), false);
  const own = await picture(first.page);
  await choose(first.page, 'look', 'clay');
  assert.notEqual(await picture(first.page), own);
  await choose(first.page, 'look', 'own');
  assert.equal(await picture(first.page), own);
  assert.deepEqual(first.problems, []);
  await first.close();
});

test('without WebGL the page says so, and compresses', { skip }, async () => {
  const plain = await openPage({ hash: '#example=terrain&effort=0', before: () => (HTMLCanvasElement.prototype.getContext = () => null) });
  await waitUntilDone(plain.page);
  assert.equal(await plain.page.$eval('#no-picture', (element) => element.hidden), false);
  for (const id of ['divider', 'label-original', 'view']) assert.equal(await plain.page.$eval(`#${id}`, (element) => element.checkVisibility()), false, id);
  assert.ok((await shownBytes(plain.page)) > 0);
  await plain.close();
});

test('on a phone, in the dark, from a link', { skip }, async () => {
  const phone = await openPage({ width: 390, height: 844, dark: true, hash: '#example=terrain&view=split&color=signed&maxError=0.2' });
  await waitUntilDone(phone.page);
  const { innerWidth, wide } = await phone.page.evaluate(() => ({ innerWidth, wide: document.documentElement.scrollWidth }));
  assert.ok(wide <= innerWidth, `${wide} px wide`);
  assert.equal(await phone.page.$eval('#maxError', (input) => input.value), '0.2');
  assert.equal(await phone.page.$eval('#divider', (divider) => divider.hidden), false);
  assert.ok((await countColors(phone.page)) > 50);
  assert.deepEqual(phone.problems, []);
  await phone.close();
});
