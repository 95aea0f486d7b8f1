// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Maps on disk: a manifest and parts that are decoded one by one. See map.d.ts.
import { CODES, DeltameshError } from './errors.js';
import { Instance, settle } from './instance.js';
import { MAP_MODULE, partMesh } from './map-part.js';
import { compileGiven, compileOwn } from './modules.js';
import { readError, readStream } from './outcome.js';

const PART_SIZE = 96;

const wide = ([low, high]) => (BigInt(high) << 32n) | BigInt(low);

/** As PartOutcome in map_outcome.h. */
function readPart(instance, address) {
  const [vde, lfe, maxError] = instance.doubles(address, 3);
  const box = new Float32Array(instance.bytes(address + 24, 24));
  const words = instance.words(address + 48, 12);
  const cell = [...new Int32Array(instance.bytes(address + 52, 12))];
  const [bytes, vertexCount, triangleCount, isFinest] = words.slice(8);
  const revision = wide(words.slice(4));
  const hash = wide(words.slice(6)).toString(16).padStart(16, '0');
  return {
    file: `parts/${[words[0], ...cell, revision, hash].join('_')}.part`,
    level: words[0],
    cell,
    bytes,
    vertexCount,
    triangleCount,
    box: { min: [...box.slice(0, 3)], max: [...box.slice(3)] },
    quality: { vde, lfe, maxError },
    isFinest: isFinest !== 0,
  };
}

class MapDecoder {
  #module;
  #manifest;
  #instance;

  constructor(module, manifest) {
    this.#module = module;
    this.#manifest = manifest;
  }

  open() {
    return settle(
      () => {
        const instance = (this.#instance = new Instance(this.#module));
        const address = instance.put(this.#manifest);
        const outcome = instance.calls.openMap(address, this.#manifest.byteLength);
        const error = readError(instance, outcome);
        if (error) return error;
        this.origin = [...instance.doubles(outcome + 32, 3)];
        const [count, parts] = instance.words(outcome + 56, 2);
        this.parts = Array.from({ length: count }, (_, i) => readPart(instance, parts + PART_SIZE * i));
        instance.calls.release(address);
        return this;
      },
      () => this.release(),
    );
  }

  decode(number, bytes) {
    const part = this.parts[number];
    if (!this.#instance) {
      const opened = this.open();
      if (opened instanceof DeltameshError) return opened;
    }
    return settle(
      () => {
        const instance = this.#instance;
        if (bytes.byteLength !== part.bytes) return new DeltameshError({ code: CODES.corrupt, what: `not as long as ${part.file}`, rule: 'MAP-10' });
        const address = instance.put(bytes);
        const outcome = instance.calls.decodePart(number, address, bytes.byteLength);
        const result = readError(instance, outcome) ?? { ...partMesh(readStream(instance, outcome, true)), box: part.box, quality: part.quality };
        instance.calls.release(address);
        instance.calls.forget();
        return result;
      },
      () => this.release(),
    );
  }

  release() {
    this.#instance = undefined;
  }
}

export async function openMap(manifest, { file } = {}) {
  return new MapDecoder(await (file === undefined ? compileOwn(MAP_MODULE) : compileGiven(file)), manifest).open();
}
