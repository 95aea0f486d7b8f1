// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// One measurement in a Chromium of its own.
import { build } from 'esbuild';

import { launch, serveFiles } from '../test/chromium.js';

async function bundle() {
  const { outputFiles } = await build({
    entryPoints: [new URL('measure.js', import.meta.url).pathname],
    bundle: true,
    write: false,
    format: 'esm',
    target: 'es2022',
    external: ['node:*', 'fs', 'path', './text/*'], // of modules that run in node, too; texts of modules that are handed over
    logLevel: 'warning',
  });
  return outputFiles[0].contents;
}

/** Serves the bundle, and the bytes that a measurement needs by their numbers. */
export class Chromium {
  #files = new Map([['/page.html', '<!doctype html><link rel="icon" href="data:,">']]);
  #count = 0;
  #server;

  async open() {
    this.#files.set('/measure.js', await bundle());
    this.#server = await serveFiles(this.#files);
    return this;
  }

  /** Bytes become numbers of files; everything else stays. */
  #numbered(value) {
    if (value instanceof Uint8Array) {
      const file = `/${this.#count++}.bin`;
      this.#files.set(file, value);
      return { file };
    }
    if (Array.isArray(value)) return value.map((item) => this.#numbered(item));
    if (typeof value !== 'object') return value;
    return Object.fromEntries(Object.entries(value).map(([key, item]) => [key, this.#numbered(item)]));
  }

  async measure(message) {
    const numbered = this.#numbered(message);
    const browser = await launch();
    try {
      const page = await browser.newPage();
      await page.goto(`${this.#server.origin}/page.html`);
      return await page.evaluate(async (numbered) => {
        const fetched = async (value) => {
          if (typeof value !== 'object') return value;
          if ('file' in value) return new Uint8Array(await (await fetch(value.file)).arrayBuffer());
          if (Array.isArray(value)) return Promise.all(value.map(fetched));
          return Object.fromEntries(await Promise.all(Object.entries(value).map(async ([key, item]) => [key, await fetched(item)])));
        };
        const { kind, codec, streams, jobs, modules } = await fetched(numbered);
        const { cold, warm } = await import('/measure.js');
        return kind === 'cold' ? cold(codec, modules, streams) : warm(jobs, modules);
      }, numbered);
    } finally {
      await browser.close();
      for (const name of this.#files.keys()) if (name.endsWith('.bin')) this.#files.delete(name);
    }
  }

  close() {
    this.#server.close();
  }
}
