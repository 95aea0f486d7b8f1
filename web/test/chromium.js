// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Chromium without a window, and a server of a few files for it.
import { existsSync } from 'node:fs';
import { createServer } from 'node:http';
import { extname } from 'node:path';

import puppeteer from 'puppeteer-core';

const CHROMIUM = process.env.CHROMIUM ?? '/usr/bin/chromium';
export const hasChromium = existsSync(CHROMIUM);

/** Without a sandbox, as root has none; WebGL by software; the same colours and sizes whatever the screen. */
const FLAGS = [
  '--no-sandbox', '--disable-dev-shm-usage', '--enable-unsafe-swiftshader', '--use-gl=angle', '--use-angle=swiftshader',
  '--force-color-profile=srgb',
];
const TYPES = { '.html': 'text/html; charset=utf-8', '.js': 'text/javascript', '.css': 'text/css', '.wasm': 'application/wasm' };

export function launch() {
  return puppeteer.launch({ executablePath: CHROMIUM, args: FLAGS, timeout: 60000, protocolTimeout: 600000 });
}

/** Serves `files`, path to bytes, on a free port; more may be added later. */
export async function serveFiles(files) {
  const server = createServer(({ url }, response) => {
    const bytes = files.get(url);
    response.writeHead(bytes ? 200 : 404, { 'content-type': TYPES[extname(url)] ?? 'application/octet-stream' }).end(bytes);
  });
  await new Promise((resolve, reject) => server.on('error', reject).listen(0, '127.0.0.1', resolve));
  return { origin: `http://127.0.0.1:${server.address().port}`, close: () => server.close() };
}
