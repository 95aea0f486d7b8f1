// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// One measurement in a process of its own: node in-node.js with a message { kind, ... } for measure.js; or from run.js.
import { fork } from 'node:child_process';
import { fileURLToPath } from 'node:url';

import { cold, memory, warm } from './measure.js';

export function measureInNode(message) {
  return new Promise((resolve, reject) => {
    const child = fork(fileURLToPath(import.meta.url), ['measure'], { serialization: 'advanced' });
    child.once('message', (times) => resolve(times));
    child.once('exit', (code) => code && reject(new Error(`the measurement ended with ${code}`)));
    child.send(message);
  });
}

if (process.argv[1] === fileURLToPath(import.meta.url) && process.argv[2] === 'measure') {
  process.once('message', async ({ kind, codec, streams, jobs, modules }) => {
    const measures = { cold: () => cold(codec, modules, streams), memory: () => memory(codec, modules, streams), warm: () => warm(jobs, modules) };
    process.send(await measures[kind](), () => process.disconnect());
  });
}
