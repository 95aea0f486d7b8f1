// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Decoders in workers. See pool.d.ts.
import { crewOf } from './crew.js';
import { bytesOf } from './decode.js';
import { DeltameshError, createDecoder } from './decoder.js';
import { moduleLoader } from './modules.js';
import { hasWorkers, startWorker } from './start-worker.js';
import WORKER from './worker-text.js';

const startOwn = () => startWorker(WORKER);
let pools = 0;

export class DecoderPool {
  #options;
  #loadModule;
  #crew;
  #key;
  #place;
  #tasks = new Set();
  #own;
  #isDisposed = false;

  constructor({ workers = 4, decoder = {}, createWorker } = {}) {
    this.#options = decoder;
    this.#loadModule = moduleLoader(decoder);
    this.#place = { limit: createWorker || hasWorkers() ? workers : 0, running: 0 };
    this.#crew = crewOf(createWorker ?? startOwn);
    // Workers keep a decoder for one set of options.
    this.#key = decoder.files ? `pool ${pools++}` : JSON.stringify([decoder.simd, decoder.maxMemory]);
  }

  async decode(given, { limits, signal } = {}) {
    const bytes = bytesOf(given);
    return bytes instanceof DeltameshError ? bytes : this.#do({ bytes, limits }, signal);
  }

  async preload() {
    const result = await this.#do({}, undefined);
    if (result instanceof DeltameshError) throw result;
  }

  #do({ bytes, limits }, signal) {
    return new Promise((resolve, reject) => {
      if (this.#isDisposed) throw new Error('the pool is disposed of');
      signal?.throwIfAborted();
      const abort = () => {
        this.#crew.cancel(task);
        task.reject(signal.reason);
      };
      const end = (settle) => (value) => {
        signal?.removeEventListener('abort', abort); // signals may live longer than tasks
        this.#tasks.delete(task);
        settle(value);
      };
      const task = { pool: this.#place, key: this.#key, loadModule: this.#loadModule, maxMemory: this.#options.maxMemory, bytes, limits };
      Object.assign(task, { resolve: end(resolve), reject: end(reject) });
      this.#tasks.add(task);
      signal?.addEventListener('abort', abort);
      if (this.#place.limit > 0) this.#crew.add(task);
      else this.#decodeHere(task);
    });
  }

  /** Where there are no workers. */
  async #decodeHere({ bytes, limits, resolve, reject }) {
    try {
      this.#own ??= createDecoder(this.#options);
      const decoder = await this.#own;
      resolve(bytes ? await decoder.decode(bytes, { limits }) : null);
    } catch (error) {
      this.#own = undefined;
      reject(error);
    }
  }

  dispose() {
    this.#isDisposed = true;
    const reason = new Error('the pool was disposed of');
    this.#crew.leave(this.#place, reason);
    for (const { reject } of this.#tasks) reject(reason);
    this.#own = undefined;
  }
}
