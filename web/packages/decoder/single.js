// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What deltamesh.js has: one script with all modules, for pages without bundlers, from anywhere, a disk too.
export { DeltameshError, createDecoder, supportsSimd } from './decoder.js';
export { EXTENSION_NAME, arrayOf, findCompressed } from './gltf.js';
export { DecoderPool } from './pool.js';
