// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Chromium without a window, with the page open in it.
import { existsSync } from 'node:fs';
import { mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

import puppeteer from 'puppeteer-core';

import { serve } from '../serve.js';

const CHROMIUM = process.env.CHROMIUM ?? '/usr/bin/chromium';

export const hasChromium = existsSync(CHROMIUM);

/** WebGL by software. */
const FLAGS = ['--no-sandbox', '--enable-unsafe-swiftshader', '--use-gl=angle', '--use-angle=swiftshader'];

/** Everything that a test needs, and `close()`. `problems`: errors of the console and of requests. */
export async function openPage({ width = 1280, height = 800, hash = '', dark = false } = {}) {
  const server = await serve();
  const downloads = await mkdtemp(join(tmpdir(), 'deltamesh-viewer-'));
  const browser = await puppeteer.launch({ executablePath: CHROMIUM, args: FLAGS, protocolTimeout: 300000 });
  const page = await browser.newPage();
  const problems = [];
  page.on('console', (message) => ['error', 'warn'].includes(message.type()) && problems.push(message.text()));
  page.on('pageerror', (error) => problems.push(error.message));
  page.on('requestfailed', (request) => problems.push(request.url()));
  const client = await browser.target().createCDPSession();
  await client.send('Browser.setDownloadBehavior', { behavior: 'allow', downloadPath: downloads });
  await page.setViewport({ width, height, deviceScaleFactor: 1 });
  await page.emulateMediaFeatures([{ name: 'prefers-color-scheme', value: dark ? 'dark' : 'light' }]);
  await page.goto(`http://localhost:${server.address().port}/${hash}`);
  return {
    page,
    problems,
    downloads,
    async close() {
      await browser.close();
      server.close();
      await rm(downloads, { recursive: true });
    },
  };
}

/** Until the page has done what it was asked. */
export async function waitUntilDone(page, timeout = 120000) {
  await page.waitForFunction(() => ['done', 'failed'].includes(document.body.dataset.state), { timeout });
}
