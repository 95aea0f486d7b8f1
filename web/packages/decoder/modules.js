// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Where modules in WebAssembly come from. Bundlers know both patterns here: they copy what `new URL('./x.wasm', import.meta.url)` names,
// and bundle what `import()` does. Where a bundler does not know the first, a module is taken from its text, which needs no file.
import { readLocalFile } from './node.js';

/** With SIMD first. Those without have no texts: machines that need them are few. */
const MODULES = {
  core: { url: () => new URL('./core.wasm', import.meta.url), text: () => import('./text/core.js') },
  highpass: { url: () => new URL('./highpass.wasm', import.meta.url), text: () => import('./text/highpass.js') },
  zstd: { url: () => new URL('./zstd.wasm', import.meta.url), text: () => import('./text/zstd.js') },
  rare: { url: () => new URL('./rare.wasm', import.meta.url), text: () => import('./text/rare.js') },
  grid: { url: () => new URL('./grid.wasm', import.meta.url), text: () => import('./text/grid.js') },
};
const MODULES_WITHOUT_SIMD = {
  core: { url: () => new URL('./core-scalar.wasm', import.meta.url) },
  highpass: { url: () => new URL('./highpass-scalar.wasm', import.meta.url) },
  zstd: MODULES.zstd,
  rare: { url: () => new URL('./rare-scalar.wasm', import.meta.url) },
  grid: { url: () => new URL('./grid-scalar.wasm', import.meta.url) },
};

/** Whether there are vectors of 128 bits: a function of one such instruction is valid. */
export function supportsSimd() {
  return WebAssembly.validate(
    new Uint8Array([0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 10, 1, 8, 0, 65, 0, 253, 15, 253, 98, 11]),
  );
}

/** Promises of modules by their URL or source, for all that use them; one that fails is forgotten, so that the next asks again. */
const compiled = new Map();
const compiledBytes = new WeakMap();

function once(known, key, compile) {
  if (!known.has(key)) {
    const module = compile();
    known.set(key, module);
    module.catch(() => known.delete(key));
  }
  return known.get(key);
}

async function fetchModule(url) {
  const local = url.protocol === 'file:' && (await readLocalFile(url));
  if (local) return WebAssembly.compile(local);
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${url}: ${response.status} ${response.statusText}`);
  const isTyped = response.headers.get('content-type')?.startsWith('application/wasm');
  if (isTyped && WebAssembly.compileStreaming) return WebAssembly.compileStreaming(response);
  return WebAssembly.compile(await response.arrayBuffer());
}

async function fromText(text) {
  const packed = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  const bytes = new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'));
  return WebAssembly.compile(await new Response(bytes).arrayBuffer());
}

async function compileFile({ url, text }) {
  try {
    return await fetchModule(url());
  } catch (error) {
    if (!text) throw error;
    try {
      return await fromText((await text()).default);
    } catch {
      throw error;
    }
  }
}

/** A file of a package: { url, text }, see MODULES. */
export function compileOwn(file) {
  return once(compiled, file, () => compileFile(file));
}

/** Of what a caller handed over: see ModuleSource in decoder.d.ts. */
export async function compileGiven(source) {
  const given = await (typeof source === 'function' ? source() : source);
  if (given instanceof WebAssembly.Module) return given;
  if (typeof given === 'string' || given instanceof URL) {
    const url = new URL(given, globalThis.document?.baseURI ?? globalThis.location?.href);
    return once(compiled, url.href, () => fetchModule(url));
  }
  if (given.arrayBuffer) return WebAssembly.compile(await given.arrayBuffer()); // a Response, whose name alone makes node load all of fetch()
  return once(compiledBytes, given, () => WebAssembly.compile(given)); // views of one buffer may be several modules
}

/** From a module's name to a promise of it. */
export function moduleLoader({ files = {}, simd = supportsSimd() } = {}) {
  const own = simd ? MODULES : MODULES_WITHOUT_SIMD;
  return (name) => (files[name] === undefined ? compileOwn(own[name]) : compileGiven(files[name]));
}
