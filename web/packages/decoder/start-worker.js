// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Workers from a script's text: no bundler has to find a file, and a page may have the packages from elsewhere.
import { threads } from './node.js';

/** A thread of node's in the shape of a browser's worker. While it has nothing to do it does not keep the process. */
class Thread {
  #thread;

  constructor(text) {
    const { Worker } = threads();
    this.#thread = new Worker(text, { eval: true });
    this.#thread.on('message', (data) => this.onmessage({ data }));
    this.#thread.on('error', (error) => this.onerror(error));
    this.#thread.unref();
  }
  postMessage(message, transfer) {
    this.#thread.postMessage(message, transfer);
  }
  setBusy(isBusy) {
    if (isBusy) this.#thread.ref();
    else this.#thread.unref();
  }
  terminate() {
    this.#thread.terminate();
  }
}

export const hasWorkers = () => Boolean(threads()) || typeof Worker !== 'undefined';

const urls = new Map();

/** Where a page forbids such workers, its callers have `createWorker`. */
export function startWorker(text) {
  if (threads()) return new Thread(text);
  if (!urls.has(text)) urls.set(text, URL.createObjectURL(new Blob([text], { type: 'text/javascript' })));
  return new Worker(urls.get(text));
}

/** What went wrong with a worker, of its event. */
export function workerError(event) {
  const reason = event?.message || 'it could not be started; where the page allows no blob: as worker-src, give createWorker';
  return new Error(`the worker failed: ${reason}`);
}
