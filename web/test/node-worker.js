// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A worker script of the packages on a thread of node's, whose messages have another shape.
import { Worker, isMainThread, parentPort, workerData } from 'node:worker_threads';

export class NodeWorker {
  #worker;

  /** @param {URL} script */
  constructor(script) {
    this.#worker = new Worker(new URL(import.meta.url), { workerData: script.href });
    this.#worker.on('message', (data) => this.onmessage({ data }));
    this.#worker.on('error', (error) => this.onerror(error));
  }
  postMessage(message, transfer) {
    this.#worker.postMessage(message, transfer);
  }
  terminate() {
    this.#worker.terminate();
  }
}

if (!isMainThread) {
  const early = [];
  globalThis.self = { postMessage: (message, transfer) => parentPort.postMessage(message, transfer) };
  parentPort.on('message', (data) => (self.onmessage ? self.onmessage({ data }) : early.push(data)));
  await import(workerData);
  for (const data of early) self.onmessage({ data });
}
