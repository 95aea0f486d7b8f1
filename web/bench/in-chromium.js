// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// One measurement in a Chromium of its own.
import { existsSync } from 'node:fs';
import { createServer } from 'node:http';

import { build } from 'esbuild';
import puppeteer from 'puppeteer-core';

const CHROMIUM = process.env.CHROMIUM ?? '/usr/bin/chromium';
export const hasChromium = existsSync(CHROMIUM);

async function bundle() {
  const { outputFiles } = await build({
    entryPoints: [new URL('measure.js', import.meta.url).pathname],
    bundle: true,
    write: false,
    format: 'esm',
    target: 'es2022',
    external: ['node:*', 'fs', 'path'], // of modules that run in node, too
    logLevel: 'warning',
  });
  return outputFiles[0].contents;
}

/** Serves the bundle, and the bytes that a measurement needs by their numbers. */
export class Chromium {
  #script = bundle();
  #files = [];
  #server = createServer(async ({ url }, response) => {
    if (url === '/measure.js') response.setHeader('content-type', 'text/javascript').end(await this.#script);
    else if (url === '/') response.setHeader('content-type', 'text/html').end('<!doctype html><link rel="icon" href="data:,">');
    else response.end(this.#files[Number(url.slice(1))]);
  });

  async open() {
    await new Promise((resolve) => this.#server.listen(0, '127.0.0.1', resolve));
    return this;
  }

  /** Bytes become numbers of files; everything else stays. */
  #numbered(value) {
    if (value instanceof Uint8Array) return { file: this.#files.push(value) - 1 };
    if (Array.isArray(value)) return value.map((item) => this.#numbered(item));
    if (typeof value !== 'object') return value;
    return Object.fromEntries(Object.entries(value).map(([key, item]) => [key, this.#numbered(item)]));
  }

  async measure(message) {
    this.#files = [];
    const numbered = this.#numbered(message);
    const browser = await puppeteer.launch({ executablePath: CHROMIUM, args: ['--no-sandbox'], protocolTimeout: 600000 });
    try {
      const page = await browser.newPage();
      await page.goto(`http://127.0.0.1:${this.#server.address().port}/`);
      return await page.evaluate(async (numbered) => {
        const fetched = async (value) => {
          if (typeof value !== 'object') return value;
          if ('file' in value) return new Uint8Array(await (await fetch(`/${value.file}`)).arrayBuffer());
          if (Array.isArray(value)) return Promise.all(value.map(fetched));
          return Object.fromEntries(await Promise.all(Object.entries(value).map(async ([key, item]) => [key, await fetched(item)])));
        };
        const { kind, codec, streams, jobs, modules } = await fetched(numbered);
        const { cold, warm } = await import('/measure.js');
        return kind === 'cold' ? cold(codec, modules, streams) : warm(jobs, modules);
      }, numbered);
    } finally {
      await browser.close();
    }
  }

  close() {
    this.#server.close();
  }
}
