// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Receives a map that changes. See receiver.d.ts.
import { Instance, settle } from './instance.js';
import { MAP_MODULE, partMesh } from './map-part.js';
import { compileGiven, compileOwn } from './modules.js';
import { readError, readStream } from './outcome.js';

const textOf = ({ level, cell }) => [level, ...cell].join('_');

/** As KeyOutcome in map_outcome.h. */
function readKeys(instance, count, address) {
  const values = new Int32Array(instance.bytes(address, 16 * count));
  return Array.from({ length: count }, (_, i) => ({ level: values[4 * i], cell: [...values.subarray(4 * i + 1, 4 * i + 4)] }));
}

/** Two halves of a number of 64 bits. */
const halves = (value) => [...new Uint32Array(new BigUint64Array([value]).buffer)];

class MapReceiver {
  #module;
  #map;
  #instance;
  #shown = new Map(); // that takeChange() told
  #lost = new Map(); // shown by an instance that failed

  constructor(module, map) {
    this.#module = module;
    this.#map = BigInt(map);
  }

  /** The module at work; another one, which has nothing yet, where one failed. */
  #begun() {
    if (this.#instance) return this.#instance;
    const instance = new Instance(this.#module);
    const [viewer] = crypto.getRandomValues(new BigUint64Array(1));
    instance.calls.openReceiver(...halves(viewer), ...halves(this.#map));
    return (this.#instance = instance);
  }

  #settle(work) {
    return settle(() => work(this.#begun()), () => this.release());
  }

  apply(message) {
    return this.#settle((instance) => {
      const address = instance.put(message);
      const error = readError(instance, instance.calls.applyMessage(address, message.byteLength));
      instance.calls.release(address);
      return error;
    });
  }

  messages(now) {
    return this.#settle((instance) => {
      const outcome = instance.calls.messagesToSend(now);
      const error = readError(instance, outcome);
      if (error) return error;
      const [count, messages] = instance.words(outcome + 32, 2);
      return Array.from({ length: count }, (_, i) => {
        const [bytes, octets] = instance.words(messages + 8 * i, 2);
        return new Uint8Array(instance.bytes(octets, bytes));
      });
    });
  }

  takeChange() {
    return this.#settle((instance) => {
      const [changedCount, changedAt, removedCount, removedAt, lackingCount, faultCount] = instance.words(instance.calls.takeChange(), 6);
      const changed = readKeys(instance, changedCount, changedAt);
      const removed = new Map([...this.#lost, ...readKeys(instance, removedCount, removedAt).map((key) => [textOf(key), key])]);
      for (const key of changed) removed.delete(textOf(key));
      this.#lost.clear();
      for (const text of removed.keys()) this.#shown.delete(text);
      for (const key of changed) this.#shown.set(textOf(key), key);
      return { changed, removed: [...removed.values()], lackingCount, faultCount };
    });
  }

  find({ level, cell }) {
    return this.#settle((instance) => {
      const outcome = instance.calls.findPart(level, ...cell);
      return outcome === 0 ? null : partMesh(readStream(instance, outcome, true));
    });
  }

  release() {
    this.#instance = undefined;
    for (const [text, key] of this.#shown) this.#lost.set(text, key);
    this.#shown.clear();
  }
}

export async function createReceiver({ map = 0n, file } = {}) {
  return new MapReceiver(await (file === undefined ? compileOwn(MAP_MODULE) : compileGiven(file)), map);
}
