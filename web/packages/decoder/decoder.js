// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Decodes deltamesh streams by WebAssembly, in browsers, workers and node. What is exported is described in decoder.d.ts; what is not
// described there is map.js's and @deltamesh/encoder's.

const FILES = {
  core: new URL('./core.wasm', import.meta.url),
  highpass: new URL('./highpass.wasm', import.meta.url),
  zstd: new URL('./zstd.wasm', import.meta.url),
  rare: new URL('./rare.wasm', import.meta.url),
};
const FILES_WITHOUT_SIMD = {
  core: new URL('./core-scalar.wasm', import.meta.url),
  highpass: new URL('./highpass-scalar.wasm', import.meta.url),
  zstd: FILES.zstd,
  rare: new URL('./rare-scalar.wasm', import.meta.url),
};
/** As parts.h numbers them. */
const PARTS = ['highpass', 'zstd', 'rare'];
const LIMITS = { vertices: 2 ** 26, triangles: 2 ** 27, attributes: 1024, attributeBytes: 2 ** 31 };

/** Memory never shrinks: an instance that has taken more than this is replaced when its call is over. */
const KEPT_BYTES = 2 ** 26;
const PAGE = 2 ** 16;
const FIRST_PAGES = 32;

const WHERE = ['', 'byte', 'line', 'vertex', 'triangle', 'attribute', 'element'];
export const KINDS = ['normal', 'color', 'uv', 'generic', 'tangent', 'joints', 'weights'];
const CODECS = ['raw', 'zstd', 'compact'];
const GEOMETRIES = ['', 'highpass', 'predictive'];
export const ARRAYS = [
  Int8Array, Uint8Array, Int16Array, Uint16Array, Int32Array, Uint32Array, Float32Array, Float64Array,
];
/** Of PartArrays. */
const RETURNED_BYTES = 36;
const NO_FILE = 300;
const OUT_OF_MEMORY = 900;
const INTERNAL = 901;

export class DeltameshError extends Error {
  constructor({ code, what, rule = '', where = null, chunk = '' }) {
    super(
      what + (where ? `, ${where.unit} ${where.position}` : '') + (chunk && `, chunk ${chunk}`) + (rule && ` [${rule}]`),
    );
    Object.assign(this, { name: 'DeltameshError', code, what, rule, where, chunk });
  }
}

/** Whether there are vectors of 128 bits: a function of one such instruction is valid. */
export function supportsSimd() {
  return WebAssembly.validate(
    new Uint8Array([0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 10, 1, 8, 0, 65, 0, 253, 15, 253, 98, 11]),
  );
}

export async function compile(source) {
  const from = await source;
  if (from instanceof WebAssembly.Module) return from;
  if (from instanceof ArrayBuffer || ArrayBuffer.isView(from)) return WebAssembly.compile(from);
  const url = new URL(from, import.meta.url);
  if (url.protocol === 'file:') {
    const { readFile } = await import(/* webpackIgnore: true */ /* @vite-ignore */ 'node:fs/promises');
    return WebAssembly.compile(await readFile(url));
  }
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${url}: ${response.status} ${response.statusText}`);
  return WebAssembly.compile(await response.arrayBuffer());
}

class OutOfMemory extends Error {}

/** A module at work, with views of its memory that are good until its next call. */
export class Instance {
  constructor(module, maxMemory = 2 ** 32, imports) {
    const maximum = Math.max(FIRST_PAGES, Math.floor(maxMemory / PAGE));
    this.memory = new WebAssembly.Memory({ initial: FIRST_PAGES, maximum });
    const env = {
      memory: this.memory,
      out_of_memory() {
        throw new OutOfMemory();
      },
      ...imports,
    };
    this.calls = new WebAssembly.Instance(module, { env }).exports;
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
    return new TextDecoder().decode(all.slice(address, size === undefined ? all.indexOf(0, address) : address + size));
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
    if (isMemory) return new DeltameshError({ code: OUT_OF_MEMORY, what: 'out of memory' });
    return new DeltameshError({ code: INTERNAL, what: `the module failed: ${error.message}` });
  }
}

function tagText(tag) {
  return tag ? String.fromCharCode(tag & 255, (tag >> 8) & 255, (tag >> 16) & 255, (tag >> 24) & 255) : '';
}

/** As ErrorOutcome in outcome.h; null where there is none. */
export function readError(instance, address) {
  const [code, what, rule, whereKind] = instance.words(address, 4);
  if (code === 0) return null;
  return new DeltameshError({
    code,
    what: instance.text(what),
    rule: instance.text(rule),
    where: whereKind ? { unit: WHERE[whereKind], position: instance.doubles(address + 16, 1)[0] } : null,
    chunk: tagText(instance.words(address + 24, 1)[0]),
  });
}

/** Reads an AttributeOutcome, with the values if the stream was decoded. */
function readAttribute(instance, address, vertices, isDecoded) {
  const [name, nameBytes, kind, type, components, flags, codedBytes, values] = instance.words(address + 8, 8);
  const attribute = {
    name: instance.text(name, nameBytes),
    kind: KINDS[kind],
    components,
    normalized: (flags & 1) !== 0,
    linear: (flags & 2) !== 0,
    codedBytes,
    error: instance.doubles(address, 1)[0],
  };
  const Array = ARRAYS[type];
  if (isDecoded) attribute.values = new Array(instance.bytes(values, vertices * components * Array.BYTES_PER_ELEMENT));
  return attribute;
}

/** Reads a StreamOutcome, with the mesh if the stream was decoded. Empty arrays have address 0. */
export function readStream(instance, address, isDecoded) {
  const [geometry, parts] = instance.words(address + 32, 2);
  const [vde, lfe, maxError] = instance.doubles(address + 112, 3);
  const box = instance.doubles(address + 64, 6);
  const words = instance.words(address + 136, 10);
  const [vertexCount, triangleCount, keepsOrder, attributeCount, attributes, chunkCount, chunks] = words;
  const [positions, indices, groups] = words.slice(7);
  const stream = {
    geometry: GEOMETRIES[geometry],
    modules: PARTS.filter((_, number) => (parts >> number) & 1),
    vertexCount,
    triangleCount,
    keepsOrder: keepsOrder !== 0,
    origin: [...instance.doubles(address + 40, 3)],
    box: { min: [...box.slice(0, 3)], max: [...box.slice(3)] },
    quality: { vde, lfe, maxError },
    attributes: Array.from({ length: attributeCount }, (_, i) => readAttribute(instance, attributes + 40 * i, vertexCount, isDecoded)),
    chunks: Array.from({ length: chunkCount }, (_, i) => {
      const [tag, codec, codedBytes, decodedBytes] = instance.words(chunks + 16 * i, 4);
      return { tag: tagText(tag), codec: CODECS[codec], codedBytes, decodedBytes };
    }),
  };
  if (!isDecoded) return stream;
  stream.positions = new Float32Array(instance.bytes(positions, 12 * vertexCount));
  stream.indices = new Uint32Array(instance.bytes(indices, 12 * triangleCount));
  stream.groups = groups ? new Uint32Array(instance.bytes(groups, 4 * triangleCount)) : null;
  return stream;
}

class Decoder {
  #files;
  #maxMemory;
  #modules = {};
  #core;
  #parts = {};
  #partError;

  constructor({ files, simd = supportsSimd(), maxMemory } = {}) {
    this.#files = { ...(simd ? FILES : FILES_WITHOUT_SIMD), ...files };
    this.#maxMemory = maxMemory;
  }

  async load(part) {
    if (part === undefined) return void (await Promise.all(PARTS.map((each) => this.load(each))));
    await (this.#modules[part] ??= compile(this.#files[part]));
    this.#modules[part] = await this.#modules[part];
  }

  inspect(bytes) {
    return this.#call(bytes, false, (core, address) => core.inspect(address, bytes.byteLength));
  }

  async decode(bytes, options) {
    const stream = this.inspect(bytes);
    if (stream instanceof DeltameshError) return stream;
    for (const part of stream.modules) {
      try {
        await this.load(part);
      } catch (error) {
        this.#modules[part] = undefined;
        return new DeltameshError({ code: NO_FILE, what: `the module ${part} could not be loaded: ${error.message}` });
      }
    }
    return this.decodeSync(bytes, options);
  }

  decodeSync(bytes, { limits } = {}) {
    const { vertices, triangles, attributes, attributeBytes } = { ...LIMITS, ...limits };
    return this.#call(bytes, true, (core, address) =>
      core.decode(address, bytes.byteLength, vertices, triangles, attributes, attributeBytes),
    );
  }

  #call(bytes, isDecoded, call) {
    return settle(
      () => {
        const core = (this.#core ??= new Instance(this.#modules.core, this.#maxMemory, this.#imports()));
        this.#partError = undefined;
        const address = core.put(bytes);
        const outcome = call(core.calls, address);
        const stream = this.#partError ?? readError(core, outcome) ?? readStream(core, outcome, isDecoded);
        core.calls.release(address);
        core.calls.forget();
        if (core.isLarge) this.#core = undefined;
        for (const [name, part] of Object.entries(this.#parts)) {
          part.calls.forget();
          if (part.isLarge) delete this.#parts[name];
        }
        return stream;
      },
      () => this.release(),
    );
  }

  #part(number) {
    const name = PARTS[number];
    if (!(this.#modules[name] instanceof WebAssembly.Module))
      throw new DeltameshError({ code: NO_FILE, what: `the module ${name} is not loaded` });
    return (this.#parts[name] ??= new Instance(this.#modules[name], this.#maxMemory, {}));
  }

  /** As in parts.h. */
  #imports() {
    const bytes = ({ memory }, address, size) => new Uint8Array(memory.buffer, address, size);
    return {
      give: (number, from, size) => this.#part(number).put(bytes(this.#core, from, size)),
      call: (number, address, returned) => {
        const part = this.#part(number);
        const outcome = part.calls.call(address);
        this.#partError = readError(part, outcome) ?? undefined;
        bytes(this.#core, returned, RETURNED_BYTES).set(bytes(part, outcome + 32, RETURNED_BYTES));
        return this.#partError?.code ?? 0;
      },
      take: (number, to, from, size) => bytes(this.#core, to, size).set(bytes(this.#part(number), from, size)),
    };
  }

  release() {
    this.#core = undefined;
    this.#parts = {};
  }
}

export async function createDecoder(options) {
  const decoder = new Decoder(options);
  await decoder.load('core');
  return decoder;
}
