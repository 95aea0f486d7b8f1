// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// An encoder in a worker. See worker.d.ts.
import { DeltameshError } from '@deltamesh/decoder';

export class EncoderWorker {
  #options;
  #createWorker;
  #worker;
  #fail;
  #last = Promise.resolve();
  #isDisposed = false;

  constructor({ encoder, createWorker } = {}) {
    this.#options = encoder;
    this.#createWorker =
      createWorker ?? (() => new Worker(new URL('./encode-worker.js', import.meta.url), { type: 'module' }));
  }

  encode(mesh, { onProgress, signal, ...options } = {}) {
    return this.#queue({ call: 'encode', mesh, options }, signal, onProgress);
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

  #run(message, signal, onProgress) {
    return new Promise((resolve, reject) => {
      if (this.#isDisposed) throw new Error('the encoder is disposed of');
      signal?.throwIfAborted();
      const worker = (this.#worker ??= this.#start());
      const abort = () => this.#end(signal.reason); // nothing else stops a module at work
      const end = (settle, value) => {
        signal?.removeEventListener('abort', abort);
        this.#fail = undefined;
        settle(value);
      };
      this.#fail = (reason) => end(reject, reason);
      signal?.addEventListener('abort', abort, { once: true });
      worker.onmessage = ({ data: { share, failure, best, result } }) => {
        if (share !== undefined) return onProgress?.(share);
        if (!failure) return end(resolve, result);
        end(resolve, Object.assign(new DeltameshError(failure), best ? { best } : {}));
      };
      worker.onerror = (event) => this.#end(new Error(event.message ?? 'the worker failed'));
      worker.postMessage(message);
    });
  }

  #start() {
    const worker = this.#createWorker();
    worker.postMessage({ start: this.#options });
    return worker;
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
