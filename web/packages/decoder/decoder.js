// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Decodes deltamesh streams by WebAssembly, in browsers, workers and node. See decoder.d.ts.
import { Decoder } from './decode.js';
import { moduleLoader } from './modules.js';

export { DeltameshError } from './errors.js';
export { supportsSimd } from './modules.js';

export async function createDecoder({ files, simd, maxMemory } = {}) {
  const decoder = new Decoder(moduleLoader({ files, simd }), maxMemory);
  await decoder.load('core');
  return decoder;
}
