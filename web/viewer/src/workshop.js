// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// The workers: reading, compressing, comparing with others.
import { LatestJob } from './latest-job.js';

function startWorker(name, message) {
  const worker = new Worker(new URL(`./${name}.js`, import.meta.url), { type: 'module' });
  worker.postMessage(message);
  return worker;
}

/** Compiled once, for all workers that come and go. */
async function compileModules() {
  const names = ['core', 'highpass', 'rare', 'zstd', 'encoder'];
  const modules = await Promise.all(
    names.map((name) => WebAssembly.compileStreaming(fetch(new URL(`./${name}.wasm`, import.meta.url)))),
  );
  return Object.fromEntries(names.map((name, i) => [name, modules[i]]));
}

export class Workshop {
  #source;

  static async open() {
    return new Workshop(await compileModules());
  }

  constructor(modules) {
    const reader = () => startWorker('read-worker', { modules });
    this.reader = new LatestJob(reader);
    this.exporter = new LatestJob(reader);
    this.wires = { original: new LatestJob(reader), result: new LatestJob(reader) };
    this.codec = new LatestJob(() => startWorker('codec-worker', { modules, ...this.#source }));
    this.map = new LatestJob(() => startWorker('map-worker', {}));
    this.packer = new LatestJob(() => startWorker('pack-worker', { modules }));
    this.peers = new LatestJob(() => startWorker('peers-worker', {}));
  }

  /** `source`: { mesh, frame }, from the reader. */
  setSource({ mesh, frame }) {
    this.#source = { mesh, frame };
    this.codec.reset();
    this.peers.cancel();
  }

  /** Ends reading, compressing and comparing. */
  cancel() {
    for (const job of [this.reader, this.codec, this.packer, this.peers]) job.cancel();
  }

  /** `others`: files that a .gltf may need. */
  read(file, others) {
    return this.reader.run({ call: 'read', file, others });
  }

  example(name) {
    return this.reader.run({ call: 'example', name });
  }

  encode(options, onProgress) {
    return this.codec.run({ call: 'encode', options }, { onProgress });
  }

  /** `request`: of requestOf(). */
  compare(request) {
    return this.peers.run({ call: 'compare', request });
  }

  edges(which, { index, attributes }) {
    return this.wires[which].run({ call: 'edges', indices: index.array, count: attributes.position.count });
  }

  /** The GLB file with its meshes packed, and all else as it is. */
  pack(file, options) {
    return this.packer.run({ call: 'pack', file, options });
  }

  glb(bytes) {
    return this.exporter.run({ call: 'glb', bytes });
  }
}
