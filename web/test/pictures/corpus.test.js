// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// All assets and meshes of the corpus, packed, in both engines, at two times of their animations and with half of their morph targets
// (npm run test:pictures; DELTAMESH_CORPUS names another folder). Judged: packed beside what it unpacks to, and packed without loss beside
// what it was. How far off that is by the default settings and by finer ones, is told. It takes long where no graphics card draws, so it
// is no gate.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';

import { hasCorpus, hasProgram } from '../browser/assets.js';
import { LOADERS, openBrowser } from '../browser/setup.js';
import { hasChromium } from '../chromium.js';

const POSES = [0.25, 0.7];
const MOST_DIFFERENT = 0.001;
/** How assets are packed, by the names that are told. */
const SETTINGS = {
  default: [],
  finer: ['--max-error', '0.002%', '--normal-error', '0.1', '--tangent-error', '0.1', '--uv-error', '0.00005', '--color-error', '1'],
  lossless: ['--lossless'],
};
/** In place of the textures, which the corpus does not have: also as a map of normals. */
const PIXEL = Buffer.from('iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIAAACQd1PeAAAADElEQVR4nGNoaPgPAAODAgAApfuJAAAAAElFTkSuQmCC', 'base64');
const skip = hasChromium && hasProgram && hasCorpus ? false : 'Chromium, the native program or the corpus is not there';

const root = fileURLToPath(new URL('../../../', import.meta.url));
const corpus = process.env.DELTAMESH_CORPUS ?? join(root, '../shared/corpus');
const folder = join(root, 'build/web/pictures');
const run = (...args) => execFileSync(join(root, 'build/release/deltamesh'), args, { stdio: ['ignore', 'ignore', 'inherit'] });

/** What is not glTF becomes so without loss. */
function originalGlb(source, name) {
  const [stream, glb] = [join(folder, `${name}.dmsh`), join(folder, `original.${name}.glb`)];
  if (/\.gl(b|tf)$/.test(source)) {
    run('gltf', 'unpack', source, glb);
    return glb;
  }
  run('encode', source, stream, '--lossless');
  run('decode', stream, glb);
  return glb;
}

const names = [];
let browser;
before(async () => {
  if (skip) return;
  mkdirSync(folder, { recursive: true });
  const sources = ['gltf', 'formats'].flatMap((part) => readdirSync(join(corpus, part)).map((name) => [name, join(corpus, part, name)]));
  const files = new Map();
  for (const [name, source] of sources.filter(([name]) => /\.(glb|gltf|ply|obj|stl|off)$/.test(name))) {
    const original = originalGlb(source, name);
    const path = (kind) => join(folder, `${kind}.${name}.glb`);
    for (const [setting, options] of Object.entries(SETTINGS)) run('gltf', 'pack', original, path(setting), ...options);
    run('gltf', 'unpack', path('default'), path('plain'));
    for (const kind of ['original', 'plain', ...Object.keys(SETTINGS)]) files.set(`/${kind}.${name}.glb`, readFileSync(path(kind)));
    for (const [, image] of readFileSync(original, 'latin1').matchAll(/"uri":"([^":]+\.(?:png|jpe?g|webp))"/g)) files.set(`/${image}`, PIXEL);
    names.push(name);
  }
  browser = await openBrowser(files);
});
after(() => browser?.close());

for (const loader of LOADERS) {
  test(`what is packed looks as it should in ${loader}`, { skip }, async (t) => {
    const { page, problems } = await browser.openPage(loader);
    const worse = [];
    for (const name of names) {
      const difference = async (before, packed) => {
        const views = await page.evaluate((...args) => window.compareAssets(...args), `/${before}.${name}.glb`, `/${packed}.${name}.glb`, POSES);
        return Math.max(...views.map((view) => view.different));
      };
      const toPlain = await difference('plain', 'default');
      const toOriginal = {};
      for (const setting of Object.keys(SETTINGS)) toOriginal[setting] = await difference('original', setting);
      const told = Object.entries(toOriginal).map(([setting, share]) => `${setting} ${(100 * share).toFixed(3)} %`);
      t.diagnostic(`${name}: pixels off what it unpacks to ${(100 * toPlain).toFixed(3)} %, what it was: ${told.join(', ')}`);
      if (Math.max(toPlain, toOriginal.lossless) > MOST_DIFFERENT) worse.push(name);
    }
    assert.deepEqual(worse, []);
    assert.deepEqual(problems, []);
    await page.close();
  });
}
