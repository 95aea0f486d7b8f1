// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A worker of a DecoderPool: first come the decoder's options, then streams, one at a time.
import { DeltameshError, createDecoder } from './decoder.js';

let decoder;

async function decode({ bytes, limits }) {
  const result = await (await decoder).decode(bytes, { limits });
  if (!(result instanceof DeltameshError)) return result;
  const { code, what, rule, where, chunk } = result;
  return { failed: { code, what, rule, where, chunk } };
}

self.onmessage = async ({ data }) => {
  if ('options' in data) {
    decoder = createDecoder(data.options);
    decoder.catch(() => {});
    return;
  }
  try {
    const { failed, ...mesh } = await decode(data);
    const arrays = failed ? [] : [mesh.positions, mesh.indices, mesh.groups, ...mesh.attributes.map(({ values }) => values)];
    const buffers = arrays.filter(Boolean).map(({ buffer }) => buffer);
    self.postMessage(failed ? { error: failed } : { mesh }, buffers);
  } catch (error) {
    self.postMessage({ error: { code: 300, what: `the decoder could not be started: ${error.message}` } });
  }
};
