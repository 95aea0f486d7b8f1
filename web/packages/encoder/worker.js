// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// An encoder in a worker. See worker.d.ts.
import { CODES, DeltameshError, startWorker, workerError } from '@deltamesh/decoder/internal.js';

import { loadEncoder } from './encoder.js';
import WORKER from './worker-text.js';

export class EncoderWorker {
  #options;
  #createWorker;
  #worker;
  #fail;
  #last = Promise.resolve();
  #isDisposed = false;

  constructor({ encoder = {}, createWorker = () => startWorker(WORKER) } = {}) {
    this.#options = encoder;
    this.#createWorker = createWorker;
  }

  /** Starts the worker before it is needed. */
  async preload() {
    await this.#start();
  }

  encode(mesh, { onProgress, signal, ...options } = {}) {
    return this.#queue({ call: 'encode', mesh, options }, signal, onProgress);
  }

  packGltf(asset, { onProgress, signal, ...options } = {}) {
    return this.#queue({ call: 'pack', asset, options }, signal, onProgress);
  }

  compare(a, b, order, { signal } = {}) {
    return this.#queue({ call: 'compare', mesh: a, other: b, order }, signal);
  }

  /** One after the other. */
  #queue(message, signal, onProgress) {
    const result = this.#last.then(() => this.#run(message, signal, onProgress));
    this.#last = result.catch(() => {});
    return result;
  }

  async #run(message, signal, onProgress) {
    try {
      await this.#start();
    } catch (error) {
      const what = `the module encoder could not be loaded: ${error.message}`;
      return new DeltameshError({ code: CODES.noFile, what }, { cause: error });
    }
    return new Promise((resolve, reject) => {
      if (this.#isDisposed) throw new Error('the encoder is disposed of');
      signal?.throwIfAborted();
      const worker = this.#worker;
      const abort = () => this.#end(signal.reason); // nothing else stops a module at work
      const end = (settle, value) => {
        signal?.removeEventListener('abort', abort);
        this.#fail = undefined;
        worker.setBusy?.(false);
        settle(value);
      };
      this.#fail = (reason) => end(reject, reason);
      signal?.addEventListener('abort', abort, { once: true });
      worker.onmessage = ({ data: { share, failure, best, result } }) => {
        if (share !== undefined) return onProgress?.(share);
        if (!failure) return end(resolve, result);
        end(resolve, Object.assign(new DeltameshError(failure), best ? { best } : {}));
      };
      worker.onerror = (event) => this.#end(workerError(event));
      worker.setBusy?.(true);
      worker.postMessage(message);
    });
  }

  async #start() {
    const module = await loadEncoder(this.#options.files);
    if (this.#worker || this.#isDisposed) return;
    this.#worker = this.#createWorker();
    this.#worker.postMessage({ module, maxMemory: this.#options.maxMemory });
  }

  #end(reason) {
    this.#worker?.terminate();
    this.#worker = undefined;
    this.#fail?.(reason);
  }

  dispose() {
    this.#isDisposed = true;
    this.#end(new Error('the encoder was disposed of'));
  }
}
