// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Encodes a mesh, decodes what came out, and measures every vertex.
import { DeltameshError, createDecoder } from '@deltamesh/decoder';
import { createEncoder } from '@deltamesh/encoder';

import { buffersOf, displayOf } from '../mesh/display.js';
import { vertexErrors } from '../mesh/vertex-errors.js';
import { answerCalls } from './answer.js';

let source;
let encoder;
let decoder;

const tell = (step, share) => self.postMessage({ progress: { step, share } });

function check(outcome) {
  if (!(outcome instanceof DeltameshError)) return outcome;
  const { best } = outcome;
  const can = best ? `; the best that can be had is ${best.value > 0 ? best.value.toPrecision(4) : `${best.bytes} bytes`}` : '';
  throw new Error(outcome.message + can);
}

async function encode({ options }) {
  tell('Compressing', 0);
  const begin = performance.now();
  const { bytes, order } = check((await encoder).encode(source.mesh, { ...options, onProgress: (share) => tell('Compressing', share) }));
  const encoded = performance.now();
  tell('Decoding', 1);
  const decoded = check(await (await decoder).decode(bytes));
  const { geometry, vertexCount, triangleCount, quality, attributes, chunks } = decoded;
  const end = performance.now();
  tell('Measuring', 1);
  const errors = vertexErrors(source.mesh, decoded, order);
  const display = displayOf(decoded, source.frame);
  const info = {
    geometry,
    vertexCount,
    triangleCount,
    quality,
    attributes: attributes.map(({ values, ...rest }) => rest),
    chunks,
    encodeMilliseconds: encoded - begin,
    decodeMilliseconds: end - encoded,
  };
  return {
    result: { bytes, info, display, errors },
    transfer: [bytes.buffer, ...buffersOf(display), ...buffersOf(errors)],
  };
}

answerCalls({
  setup: ({ mesh, frame, modules }) => {
    source = { mesh, frame };
    encoder = createEncoder({ files: modules });
    decoder = createDecoder({ files: modules });
  },
  encode,
});
