// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Chromium with pages that load by three.js and by Babylon.js.
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';

import { build } from 'esbuild';

import { launch, serveFiles } from '../chromium.js';

const DECODER = new URL('../../packages/decoder/', import.meta.url);
export const LOADERS = ['three', 'babylon'];
const PAGES = [...LOADERS, 'babylon-readme'];

async function bundles() {
  const scripts = Object.fromEntries(PAGES.map((name) => [name, new URL(`in-${name}.js`, import.meta.url)]));
  scripts['decoder-worker'] = new URL('worker.js', DECODER); // for pages that allow no worker from a text
  const { outputFiles } = await build({
    entryPoints: Object.entries(scripts).map(([out, url]) => ({ in: fileURLToPath(url), out })),
    outdir: '/',
    bundle: true,
    write: false,
    format: 'esm',
    target: 'es2022',
    splitting: true,
    logLevel: 'error',
  });
  return outputFiles.map(({ path, contents }) => [path, contents]);
}

/** `files`: path to bytes, which are served beside what the pages need. */
export async function openBrowser(files) {
  const all = new Map([...(await bundles()), ...files]);
  for (const name of ['core', 'highpass', 'rare', 'grid', 'zstd']) all.set(`/${name}.wasm`, readFileSync(new URL(`${name}.wasm`, DECODER)));
  for (const name of PAGES)
    all.set(`/${name}.html`, `<!doctype html><link rel="icon" href="data:,"><body><script type="module" src="${name}.js"></script>`);
  const policy = "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'self' data: 'wasm-unsafe-eval'\">";
  all.set('/three-strict.html', `${all.get('/three.html').replace('<link', `${policy}<link`)}`);
  const server = await serveFiles(all);
  const browser = await launch();
  return {
    /** A page with what in-three.js or in-babylon.js gives it; `problems`: errors that nothing caught. */
    async openPage(loader) {
      const page = await browser.newPage();
      await page.setViewport({ width: 600, height: 600, deviceScaleFactor: 1 });
      const problems = [];
      page.on('pageerror', (error) => problems.push(String(error)));
      await page.goto(`${server.origin}/${loader}.html`);
      await page.waitForFunction(() => window.isReady);
      return { page, problems };
    },
    async close() {
      await browser.close();
      server.close();
    },
  };
}
