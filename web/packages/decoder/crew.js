// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Workers that all pools of a page share: as many as the pool that wants most, however many pools there are.
import { DeltameshError } from './errors.js';
import { workerError } from './start-worker.js';

/** A worker with one task at a time. */
class Helper {
  task = null;
  hasFailed = false;

  constructor(worker, onFree) {
    this.worker = worker;
    this.onFree = onFree;
    worker.onmessage = ({ data }) => (data.need ? this.#load(data.need) : this.#end(data));
    worker.onerror = (event) => {
      event?.preventDefault?.();
      this.fail(workerError(event));
    };
  }

  run(task) {
    this.task = task;
    this.worker.setBusy?.(true);
    const { key, maxMemory, limits } = task;
    const bytes = task.bytes && new Uint8Array(task.bytes);
    this.worker.postMessage({ key, maxMemory, limits, bytes }, bytes ? [bytes.buffer] : []);
  }

  async #load(name) {
    try {
      this.worker.postMessage({ name, module: await this.task?.loadModule(name) });
    } catch (error) {
      this.worker.postMessage({ name, failure: error.message });
    }
  }

  #end({ error, mesh }) {
    if (this.hasFailed) return; // the message was on its way already
    const { task } = this;
    this.task = null;
    this.worker.setBusy?.(false);
    task.resolve(error ? new DeltameshError(error) : mesh);
    this.onFree(task);
  }

  /** Nothing else stops a worker. */
  fail(reason) {
    const { task } = this;
    this.task = null;
    this.hasFailed = true;
    this.worker.terminate();
    task?.reject(reason);
    this.onFree(task);
  }
}

class Crew {
  #createWorker;
  #helpers = [];
  #waiting = [];
  /** Pools that have not been disposed of. */
  #pools = new Set();

  constructor(createWorker) {
    this.#createWorker = createWorker;
  }

  /** `pool`: { limit, running }; task: { pool, key, loadModule, maxMemory, bytes, limits, resolve, reject }. */
  add(task) {
    this.#pools.add(task.pool);
    this.#waiting.push(task);
    this.#next();
  }

  /** A task that waits is forgotten; the mesh of one that is worked on goes nowhere. */
  cancel(task) {
    this.#waiting = this.#waiting.filter((other) => other !== task);
  }

  #next() {
    for (;;) {
      const task = this.#waiting.find(({ pool }) => pool.running < pool.limit);
      const helper = task && this.#helperFor(task);
      if (!helper) return;
      this.#waiting = this.#waiting.filter((other) => other !== task);
      ++task.pool.running;
      helper.run(task);
    }
  }

  #helperFor(task) {
    const idle = this.#helpers.filter((helper) => helper.task === null);
    const found = idle.find(({ lastKey }) => lastKey === task.key) ?? (this.#helpers.length < task.pool.limit ? this.#hire() : idle[0]);
    if (found) found.lastKey = task.key;
    return found;
  }

  #hire() {
    const helper = new Helper(this.#createWorker(), (task) => {
      if (task) --task.pool.running;
      this.#helpers = this.#helpers.filter(({ hasFailed }) => !hasFailed);
      this.#next();
    });
    this.#helpers.push(helper);
    return helper;
  }

  /** Ends what is done for `pool`; where it was the last, all workers. */
  leave(pool, reason) {
    this.#pools.delete(pool);
    const waiting = this.#waiting.filter((task) => task.pool === pool);
    this.#waiting = this.#waiting.filter((task) => task.pool !== pool);
    for (const helper of [...this.#helpers]) if (helper.task?.pool === pool || this.#pools.size === 0) helper.fail(reason);
    for (const { reject } of waiting) reject(reason);
  }
}

const crews = new WeakMap();

/** The crew of workers that `createWorker` makes. */
export function crewOf(createWorker) {
  if (!crews.has(createWorker)) crews.set(createWorker, new Crew(createWorker));
  return crews.get(createWorker);
}
