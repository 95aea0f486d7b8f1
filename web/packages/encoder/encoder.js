// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Encodes and compares meshes by WebAssembly. See encoder.d.ts.
import { compileGiven, compileOwn } from '@deltamesh/decoder/internal.js';

import { Encoder } from './encode.js';

const MODULE = { url: () => new URL('./encoder.wasm', import.meta.url), text: () => import('./text/encoder.js') };

/** Compiled once for all encoders of a page. `files`: of EncoderOptions. */
export function loadEncoder(files = {}) {
  return files.encoder === undefined ? compileOwn(MODULE) : compileGiven(files.encoder);
}

export async function createEncoder({ files, maxMemory } = {}) {
  return new Encoder(await loadEncoder(files), maxMemory);
}
