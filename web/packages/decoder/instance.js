// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A module in WebAssembly at work.
import { CODES, DeltameshError } from './errors.js';

/** Memory never shrinks: an instance that has taken more than this is replaced when its call is over. */
const KEPT_BYTES = 2 ** 26;
const PAGE = 2 ** 16;
const FIRST_PAGES = 32;
const MOST_PAGES = 2 ** 16;

const LETTERS = new TextDecoder();

class OutOfMemory extends Error {}

/** A module at work, with views of its memory that are good until its next call. */
export class Instance {
  /** `imports`: more of them, by module and name. */
  constructor(module, maxMemory = Infinity, imports = {}) {
    if (!(maxMemory >= 0)) throw new DeltameshError({ code: CODES.invalidArgument, what: 'maxMemory is a number of bytes' });
    const maximum = Math.min(Math.max(FIRST_PAGES, Math.floor(maxMemory / PAGE)), MOST_PAGES);
    this.memory = new WebAssembly.Memory({ initial: FIRST_PAGES, maximum });
    const env = {
      memory: this.memory,
      out_of_memory() {
        throw new OutOfMemory();
      },
      ...imports.env,
    };
    this.calls = new WebAssembly.Instance(module, { ...imports, env }).exports;
    this.calls._initialize();
  }

  get isLarge() {
    return this.memory.buffer.byteLength > KEPT_BYTES;
  }

  /** A copy. */
  bytes(address, size) {
    return this.memory.buffer.slice(address, address + size);
  }
  words(address, count) {
    return new Uint32Array(this.memory.buffer, address, count);
  }
  doubles(address, count) {
    return new Float64Array(this.memory.buffer, address, count);
  }
  /** `size`: bytes; without it up to a zero. */
  text(address, size) {
    const all = new Uint8Array(this.memory.buffer);
    return LETTERS.decode(all.subarray(address, size === undefined ? all.indexOf(0, address) : address + size));
  }

  /** Its address; release it. */
  put(bytes) {
    const address = this.calls.allocate(bytes.byteLength);
    new Uint8Array(this.memory.buffer, address, bytes.byteLength).set(bytes);
    return address;
  }
}

/** The result of `work`, or an error. Instances that fail are not used again: `drop` sees to it. */
export function settle(work, drop) {
  try {
    return work();
  } catch (error) {
    drop();
    if (error instanceof DeltameshError) return error;
    const isMemory = error instanceof OutOfMemory || error instanceof RangeError;
    if (isMemory) return new DeltameshError({ code: CODES.outOfMemory, what: 'out of memory' });
    return new DeltameshError({ code: CODES.internal, what: `the module failed: ${error.message}` });
  }
}
