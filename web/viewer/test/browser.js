// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Chromium without a window, with the page open in it.
import { mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

import { launch } from '../../test/chromium.js';
import { bridge } from '../bridge.js';
import { serve } from '../serve.js';

export { hasChromium } from '../../test/chromium.js';

/**
 * Everything that a test needs, and `close()`. `hash`: or a query; `before`: runs in the page before its scripts; `udpPort`: see bridge.js;
 * `isPhone`: with fingers.
 * `problems`: errors of the console and of requests.
 */
export async function openPage({ width = 1280, height = 800, hash = '', dark = false, isPhone = false, before, udpPort } = {}) {
  const server = await serve();
  if (udpPort) bridge(server, udpPort);
  const downloads = await mkdtemp(join(tmpdir(), 'deltamesh-viewer-'));
  const browser = await launch();
  const page = await browser.newPage();
  const problems = [];
  page.on('console', (message) => ['error', 'warn'].includes(message.type()) && problems.push(message.text()));
  page.on('pageerror', (error) => problems.push(error.message));
  page.on('requestfailed', (request) => problems.push(request.url()));
  const client = await browser.target().createCDPSession();
  await client.send('Browser.setDownloadBehavior', { behavior: 'allow', downloadPath: downloads });
  await page.setViewport({ width, height, deviceScaleFactor: 1, isMobile: isPhone, hasTouch: isPhone });
  await page.emulateMediaFeatures([{ name: 'prefers-color-scheme', value: dark ? 'dark' : 'light' }]);
  if (before) await page.evaluateOnNewDocument(before);
  await page.goto(`http://localhost:${server.address().port}/${hash}`, { waitUntil: 'domcontentloaded', timeout: 120000 });
  return {
    page,
    port: server.address().port,
    problems,
    downloads,
    async close() {
      await browser.close();
      server.closeAllConnections();
      server.close();
      await rm(downloads, { recursive: true });
    },
  };
}

/** Until the page has done what it was asked. */
export async function waitUntilDone(page, timeout = 120000) {
  await page.waitForFunction(() => ['done', 'failed'].includes(document.body.dataset.state), { timeout });
}
