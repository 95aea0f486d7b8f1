// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The worker of an EncoderWorker: first come the encoder's options, then calls, one at a time.
import { DeltameshError } from '@deltamesh/decoder';

import { createEncoder } from './encoder.js';

let encoder;

function run(encoder, { call, mesh, other, order, options }) {
  if (call === 'compare') return encoder.compare(mesh, other, order ?? undefined);
  const onProgress = (share) => self.postMessage({ share });
  return encoder.encode(mesh, { ...options, onProgress });
}

function failureOf({ code, what, rule, where, chunk, best }) {
  return { failure: { code, what, rule, where, chunk }, best };
}

self.onmessage = async ({ data }) => {
  if ('start' in data) {
    encoder = createEncoder(data.start);
    encoder.catch(() => {});
    return;
  }
  try {
    const result = run(await encoder, data);
    if (result instanceof DeltameshError) return self.postMessage(failureOf(result));
    self.postMessage({ result }, [(result.bytes ?? result.signedError).buffer]);
  } catch (error) {
    self.postMessage(failureOf({ code: 300, what: `the encoder could not be started: ${error.message}` }));
  }
};
