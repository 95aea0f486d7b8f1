// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// A worker that does one thing at a time; new work ends the old.

/** The reason of work that was given up. */
export class Superseded extends Error {}

export class LatestJob {
  #create;
  #worker = null;
  #reject = null;

  /** `create`: makes a worker and gives it what it needs first. */
  constructor(create) {
    this.#create = create;
  }

  get isBusy() {
    return this.#reject !== null;
  }

  /**
   * The worker answers with { progress }, any number of times, then { result } or { error }, a text. Rejects with a Superseded where
   * other work came first.
   */
  run(message, { transfer = [], onProgress } = {}) {
    this.cancel();
    return new Promise((resolve, reject) => {
      this.#reject = reject;
      const end = (settle, value) => {
        this.#reject = null;
        settle(value);
      };
      const worker = (this.#worker ??= this.#create());
      worker.onmessage = ({ data }) => {
        if ('progress' in data) onProgress?.(data.progress);
        else if ('error' in data) end(reject, new Error(data.error));
        else if ('result' in data) end(resolve, data.result);
      };
      worker.onerror = (event) => {
        this.#worker = null;
        worker.terminate();
        end(reject, new Error(event.message || 'the worker failed'));
      };
      worker.postMessage(message, transfer);
    });
  }

  /** Ends what is being worked on, and its worker with it: nothing else stops WebAssembly. */
  cancel() {
    if (this.isBusy) this.reset();
  }

  /** Ends the worker; the next work starts another. */
  reset() {
    this.#worker?.terminate();
    this.#worker = null;
    this.#reject?.(new Superseded());
    this.#reject = null;
  }
}
