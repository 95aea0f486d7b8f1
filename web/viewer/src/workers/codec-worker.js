// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Encodes a mesh, decodes what came out, and measures every vertex.
import { createEncoder } from '@deltamesh/encoder';

import { buffersOf } from '../mesh/display.js';
import { vertexErrors } from '../mesh/vertex-errors.js';
import { answerCalls, modules } from './answer.js';
import { check, decode, resultOf } from './result.js';

let source;
let encoder;

const tell = (step, share) => self.postMessage({ progress: { step, share } });

async function encode({ options }) {
  tell('Compressing', 0);
  encoder ??= createEncoder({ files: modules }).catch((error) => {
    encoder = undefined; // the next one tries again
    throw error;
  });
  const ready = await encoder;
  const begin = performance.now();
  const encoded = check(ready.encode(source.mesh, { ...options, onProgress: (share) => tell('Compressing', share) }));
  const encodeMilliseconds = performance.now() - begin;
  tell('Decoding', 1);
  const result = await resultOf(encoded, source.frame, { encodeMilliseconds });
  return { result, transfer: [encoded.bytes.buffer, encoded.order.buffer, ...buffersOf(result.display)] };
}

answerCalls({
  setup: ({ mesh, frame }) => (source = { mesh, frame }),
  encode,
  errors: async ({ bytes, order }) => {
    const errors = vertexErrors(source.mesh, await decode(bytes), order);
    return { result: errors, transfer: buffersOf(errors) };
  },
});
