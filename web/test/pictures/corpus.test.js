// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// All assets and meshes of the corpus, packed by the default settings, in both engines, at two times of their animations and with half of
// their morph targets (npm run test:pictures): judged beside what they unpack to; how far off what they were is, is told. It takes long
// where no graphics card draws, so it is no gate.
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
    const [packed, plain] = ['packed', 'plain'].map((kind) => join(folder, `${kind}.${name}.glb`));
    run('gltf', 'pack', original, packed);
    run('gltf', 'unpack', packed, plain);
    for (const [kind, path] of Object.entries({ original, packed, plain })) files.set(`/${kind}.${name}.glb`, readFileSync(path));
    names.push(name);
  }
  // Images that are files of their own.
  for (const file of readdirSync(folder).filter((name) => /\.(png|jpe?g|webp)$/.test(name))) files.set(`/${file}`, readFileSync(join(folder, file)));
  browser = await openBrowser(files);
});
after(() => browser?.close());

for (const loader of LOADERS) {
  test(`what is packed looks as what it unpacks to in ${loader}`, { skip }, async (t) => {
    const { page, problems } = await browser.openPage(loader);
    const worse = [];
    for (const name of names) {
      const differenceTo = async (kind) => {
        const views = await page.evaluate((...args) => window.compareAssets(...args), `/${kind}.${name}.glb`, `/packed.${name}.glb`, POSES);
        return Math.max(...views.map((view) => view.different));
      };
      const [different, off] = [await differenceTo('plain'), await differenceTo('original')];
      t.diagnostic(`${name}: ${(100 * different).toFixed(3)} % of the pixels differ, ${(100 * off).toFixed(3)} % from what it was`);
      if (different > MOST_DIFFERENT) worse.push(name);
    }
    assert.deepEqual(worse, []);
    assert.deepEqual(problems, []);
    await page.close();
  });
}
