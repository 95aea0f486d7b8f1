#!/usr/bin/env node
// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Serves dist/ on this machine: node serve.js [PORT [UDP_PORT]]; UDP_PORT: where a publisher of a map listens, see bridge.js.
import { realpathSync } from 'node:fs';
import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import { extname } from 'node:path';
import { fileURLToPath } from 'node:url';

import { bridge } from './bridge.js';

const TYPES = {
  '.html': 'text/html; charset=utf-8',
  '.css': 'text/css',
  '.js': 'text/javascript',
  '.wasm': 'application/wasm',
  '.map': 'application/json',
  '.webp': 'image/webp',
};
const dist = new URL('./dist/', import.meta.url);

/** A server of dist/ that listens; `port` 0: any free one. */
export async function serve(port = 0) {
  const server = createServer(async (request, response) => {
    try {
      const name = new URL(request.url, 'http://localhost').pathname.slice(1) || 'index.html';
      if (!/^[\w.-]+$/.test(name)) throw new Error('not a file of dist/');
      const body = await readFile(new URL(name, dist));
      response.writeHead(200, { 'content-type': TYPES[extname(name)] ?? 'application/octet-stream' }).end(body);
    } catch {
      response.writeHead(404).end();
    }
  });
  await new Promise((resolve, reject) => server.on('error', reject).listen(port, '127.0.0.1', resolve));
  return server;
}

if (process.argv[1] && realpathSync(process.argv[1]) === fileURLToPath(import.meta.url)) {
  const [port = 8080, udpPort] = process.argv.slice(2).map(Number);
  const server = await serve(port);
  if (udpPort) bridge(server, udpPort);
  console.log(`http://localhost:${server.address().port}/${udpPort ? '?live=live&map=NUMBER' : ''}`);
}
