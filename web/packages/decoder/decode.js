// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Decodes streams by the modules, wherever these come from.
import { CODES, DeltameshError } from './errors.js';
import { Instance, settle } from './instance.js';
import { PARTS, readError, readStream } from './outcome.js';

const LIMITS = { vertices: 2 ** 26, triangles: 2 ** 27, attributes: 1024, attributeBytes: 2 ** 31 };
/** Core's stack that its allocator may use while a part runs, bytes. */
const ALLOCATOR_STACK = 2 ** 16;

/** What a stream was given as, as bytes; or an error that tells what to pass. */
export function bytesOf(given) {
  if (given instanceof Uint8Array) return given;
  if (ArrayBuffer.isView(given)) return new Uint8Array(given.buffer, given.byteOffset, given.byteLength);
  // Also of another realm: an iframe's, a worker's.
  if (Object.prototype.toString.call(given).endsWith('ArrayBuffer]')) return new Uint8Array(given);
  const kind = given?.constructor?.name ?? String(given);
  return new DeltameshError({ code: CODES.invalidArgument, what: `a stream is given as Uint8Array or ArrayBuffer, not as ${kind}` });
}

export function noModule(name, error) {
  return new DeltameshError({ code: CODES.noFile, what: `the module ${name} could not be loaded: ${error.message}` }, { cause: error });
}

/** `loadModule`: from a module's name to a promise of it; asked again where that failed. */
export class Decoder {
  #loadModule;
  #maxMemory;
  #modules = {};
  #core;
  #parts = {};

  constructor(loadModule, maxMemory) {
    this.#loadModule = loadModule;
    this.#maxMemory = maxMemory;
  }

  async load(part) {
    if (part === undefined) return void (await Promise.all(['core', ...PARTS].map((each) => this.load(each))));
    this.#modules[part] ??= await this.#loadModule(part);
    if (part === 'core') settle(() => this.#instance(), () => this.release()); // the first decode need not; it tells what is wrong
  }

  #instance() {
    return (this.#core ??= new Instance(this.#modules.core, this.#maxMemory, this.#partImports()));
  }

  inspect(given) {
    const bytes = bytesOf(given);
    if (bytes instanceof DeltameshError) return bytes;
    return this.#call(bytes, false, (core, address) => core.inspect(address, bytes.byteLength));
  }

  async decode(bytes, options) {
    const stream = this.inspect(bytes);
    if (stream instanceof DeltameshError) return stream;
    for (const part of stream.modules) {
      try {
        await this.load(part);
      } catch (error) {
        return noModule(part, error);
      }
    }
    return this.decodeSync(bytes, options);
  }

  decodeSync(given, { limits } = {}) {
    const bytes = bytesOf(given);
    if (bytes instanceof DeltameshError) return bytes;
    const { vertices, triangles, attributes, attributeBytes } = { ...LIMITS, ...limits };
    return this.#call(bytes, true, (core, address) =>
      core.decode(address, bytes.byteLength, vertices, triangles, attributes, attributeBytes),
    );
  }

  #call(bytes, isDecoded, call) {
    return settle(
      () => {
        const core = this.#instance();
        const address = core.put(bytes);
        const outcome = call(core.calls, address);
        const stream = readError(core, outcome) ?? readStream(core, outcome, isDecoded);
        core.calls.release(address);
        core.calls.forget();
        if (core.isLarge) this.release();
        return stream;
      },
      () => this.release(),
    );
  }

  /** What core imports from its parts, which work in its memory and on what is left of its stack (web/wasm/part.h). Each starts at its first call. */
  #partImports() {
    const imports = {};
    for (const { module: part, name } of WebAssembly.Module.imports(this.#modules.core)) {
      if (part === 'env') continue;
      (imports[part] ??= {})[name] = (...values) => {
        const { stackRestore, [name]: call } = (this.#parts[part] ??= this.#startPart(part));
        stackRestore(this.#stackOfPart());
        return call(...values);
      };
    }
    return imports;
  }

  #startPart(name) {
    if (!this.#modules[name])
      throw new DeltameshError({ code: CODES.noFile, what: `the module ${name} is not loaded` });
    const { memory, calls } = this.#core;
    const env = { memory, allocate: calls.allocate, release: calls.release };
    const part = new WebAssembly.Instance(this.#modules[name], { env }).exports;
    if (part.release_of() !== calls.release_of())
      throw new DeltameshError({ code: CODES.noFile, what: `the module ${name} is of another release than core` });
    part.stackRestore(this.#stackOfPart());
    part._initialize();
    return part;
  }

  #stackOfPart() {
    return this.#core.calls.stackSave() - ALLOCATOR_STACK;
  }

  release() {
    this.#core = undefined;
    this.#parts = {};
  }
}
