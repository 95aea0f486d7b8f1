// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Decoders in workers. See pool.d.ts.
import { DeltameshError, createDecoder } from './decoder.js';

/** A worker with one task at a time; what waits stays in the pool, where it can be cancelled. */
class Helper {
  task = null;

  constructor(worker, onFree) {
    this.worker = worker;
    worker.onmessage = ({ data }) => {
      const { resolve } = this.task;
      this.task = null;
      resolve(data.error ? new DeltameshError(data.error) : data.mesh);
      onFree();
    };
    worker.onerror = (event) => {
      this.task?.reject(new Error(event.message ?? 'the worker could not be started'));
      this.task = null;
      this.hasFailed = true;
      worker.terminate();
      onFree();
    };
  }

  run(task) {
    this.task = task;
    const bytes = new Uint8Array(task.bytes);
    this.worker.postMessage({ bytes, limits: task.limits }, [bytes.buffer]);
  }
}

export class DecoderPool {
  #limit;
  #options;
  #createWorker;
  #helpers = [];
  #waiting = [];
  #here = new Set();
  #own;
  #isDisposed = false;

  constructor({ workers = 4, decoder, createWorker } = {}) {
    this.#limit = createWorker || typeof Worker !== 'undefined' ? workers : 0;
    this.#options = decoder;
    this.#createWorker =
      createWorker ?? (() => new Worker(new URL('./worker.js', import.meta.url), { type: 'module' }));
  }

  decode(bytes, { limits, signal } = {}) {
    return new Promise((resolve, reject) => {
      if (this.#isDisposed) throw new Error('the pool is disposed of');
      signal?.throwIfAborted();
      const abort = () => this.#cancel(task, signal.reason);
      const end = (settle) => (value) => {
        signal?.removeEventListener('abort', abort); // signals may live longer than tasks
        settle(value);
      };
      const task = { bytes, limits, resolve: end(resolve), reject: end(reject) };
      this.#waiting.push(task);
      signal?.addEventListener('abort', abort);
      this.#next();
    });
  }

  /** A task that is being worked on is given up: its mesh goes nowhere. */
  #cancel(task, reason) {
    this.#waiting = this.#waiting.filter((other) => other !== task);
    task.reject(reason);
  }

  #next() {
    this.#helpers = this.#helpers.filter((helper) => !helper.hasFailed);
    while (this.#waiting.length > 0) {
      if (this.#limit === 0) return this.#decodeHere(this.#waiting.shift());
      const helper = this.#helpers.find(({ task }) => task === null) ?? this.#hire();
      if (!helper) return;
      helper.run(this.#waiting.shift());
    }
  }

  #hire() {
    if (this.#helpers.length >= this.#limit) return undefined;
    const helper = new Helper(this.#createWorker(), () => this.#next());
    helper.worker.postMessage({ options: this.#options });
    this.#helpers.push(helper);
    return helper;
  }

  /** Where there are no workers. */
  async #decodeHere(task) {
    const { bytes, limits, resolve, reject } = task;
    this.#here.add(task);
    try {
      this.#own ??= createDecoder(this.#options);
      resolve(await (await this.#own).decode(bytes, { limits }));
    } catch (error) {
      this.#own = undefined;
      reject(error);
    }
    this.#here.delete(task);
    this.#next();
  }

  dispose() {
    this.#isDisposed = true;
    const reason = new Error('the pool was disposed of');
    for (const { worker, task } of this.#helpers) {
      worker.terminate();
      task?.reject(reason);
    }
    for (const task of [...this.#waiting, ...this.#here]) task.reject(reason);
    this.#helpers = [];
    this.#waiting = [];
    this.#own = undefined;
  }
}
