// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// The workers: reading, compressing, comparing with others.
import { LatestJob } from './latest-job.js';

const compiled = {};

/** Compiled when first asked for, once for all workers that come and go. */
function moduleOf(name) {
  const compile = () => WebAssembly.compileStreaming(fetch(new URL(`./${name}.wasm`, import.meta.url)));
  return (compiled[name] ??= compile().catch((error) => {
    delete compiled[name];
    throw error;
  }));
}

function startWorker(name, message) {
  const worker = new Worker(new URL(`./${name}.js`, import.meta.url), { type: 'module' });
  worker.addEventListener('message', async ({ data: { wanted } }) => {
    if (!wanted) return;
    try {
      worker.postMessage({ name: wanted, module: await moduleOf(wanted) });
    } catch (error) {
      worker.postMessage({ name: wanted, failure: `the module ${wanted} could not be loaded: ${error.message}` });
    }
  });
  if (message) worker.postMessage(message);
  return worker;
}

/** Where it cannot be told, false. */
export function isDrawnBySoftware() {
  return new Promise((resolve) => {
    const worker = new Worker(new URL('./renderer-worker.js', import.meta.url), { type: 'module' });
    const end = (isSoftware) => {
      worker.terminate();
      resolve(isSoftware);
    };
    worker.onmessage = ({ data }) => end(data);
    worker.onerror = () => end(false); // of browsers whose workers do not draw
  });
}

export class Workshop {
  #source;

  constructor() {
    const reader = () => startWorker('read-worker');
    this.examples = new LatestJob(() => startWorker('example-worker'));
    this.reader = new LatestJob(reader);
    this.exporter = new LatestJob(reader);
    this.wires = { original: new LatestJob(reader), result: new LatestJob(reader) };
    this.codec = new LatestJob(() => startWorker('codec-worker', this.#source));
    this.map = new LatestJob(() => startWorker('map-worker', {}));
    this.packer = new LatestJob(() => startWorker('pack-worker'));
    this.peers = new LatestJob(() => startWorker('peers-worker'));
  }

  /** `source`: { mesh, frame }, from the reader. */
  setSource({ mesh, frame }) {
    this.#source = { mesh, frame };
    this.codec.reset();
    this.peers.cancel();
  }

  /** What the next work needs, before it comes. */
  prepare() {
    for (const name of ['encoder', 'core', 'highpass']) moduleOf(name).catch(() => {}); // who needs it will ask again
  }

  /** A worker that follows a map: see live-worker.js. */
  follow(message) {
    return startWorker('live-worker', message);
  }

  /** Ends reading, compressing and comparing. */
  cancel() {
    for (const job of [this.examples, this.reader, this.codec, this.packer, this.peers]) job.cancel();
  }

  /** `others`: files that a .gltf may need. */
  read(file, others) {
    return this.reader.run({ call: 'read', file, others });
  }

  /** With `prepared`, the result that is a part of the page: { bytes, order, info, display }. */
  example(name) {
    moduleOf('core').catch(() => {}); // the worker asks for it
    return this.examples.run({ call: 'example', name });
  }

  /** As `prepared` of example(). */
  encode(options, onProgress) {
    return this.codec.run({ call: 'encode', options }, { onProgress });
  }

  /** Of a result, for every vertex: see vertexErrors(). */
  errors({ bytes, order }) {
    return this.codec.run({ call: 'errors', bytes, order });
  }

  /** `request`: of requestOf(). */
  compare(request) {
    return this.peers.run({ call: 'compare', request });
  }

  /** `which`: 'original' or 'result', a Surface. */
  edges(which, { geometry: { index, attributes }, copies }) {
    return this.wires[which].run({ call: 'edges', indices: index.array, count: attributes.position.count, copies });
  }

  /** The GLB file with its meshes packed, and all else as it is. */
  pack(file, options) {
    return this.packer.run({ call: 'pack', file, options });
  }

  glb(bytes) {
    return this.exporter.run({ call: 'glb', bytes });
  }
}
