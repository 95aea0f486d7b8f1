// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The worker of an EncoderWorker: first come the module, compiled, and its most memory; then calls, one at a time.
import { CODES, DeltameshError, listen, plainError, post } from '@deltamesh/decoder/internal.js';

import { Encoder } from './encode.js';

let encoder;

function run({ call, mesh, other, order, asset, options }) {
  if (call === 'compare') return encoder.compare(mesh, other, order ?? undefined);
  const onProgress = (share) => post({ share });
  if (call === 'pack') return encoder.packGltf(asset, { ...options, onProgress });
  return encoder.encode(mesh, { ...options, onProgress });
}

listen((message) => {
  if (message.module) {
    encoder = new Encoder(message.module, message.maxMemory);
    return;
  }
  try {
    const result = run(message);
    if (result instanceof DeltameshError) return post({ failure: plainError(result), best: result.best });
    post({ result }, [(result.bytes ?? result.signedError).buffer]);
  } catch (error) {
    post({ failure: { code: CODES.internal, what: `the encoder failed: ${error.message}` } });
  }
});
