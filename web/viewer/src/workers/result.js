// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Meshes and streams as the page shows them. For workers.
import { DeltameshError, createDecoder } from '@deltamesh/decoder';

import { buffersOf, displayOf, frameOf } from '../mesh/display.js';
import { modules } from './answer.js';

/** A mesh of readMesh() or makeExample(), with its frame and display, as a worker answers with it. */
export function shown({ mesh, ...about }) {
  const frame = frameOf(mesh);
  const display = displayOf(mesh, frame);
  const own = [mesh.positions, mesh.indices, mesh.groups, ...mesh.attributes.map(({ values }) => values)];
  const buffers = [...own.filter(Boolean).map(({ buffer }) => buffer), ...buffersOf(display)];
  return { result: { mesh, frame, display, ...about }, transfer: [...new Set(buffers)] };
}

let decoder;

/** Throws what a person can read. */
export function check(outcome) {
  if (!(outcome instanceof DeltameshError)) return outcome;
  const { best } = outcome;
  const can = best ? `; the best that can be had is ${best.value > 0 ? best.value.toPrecision(4) : `${best.bytes} bytes`}` : '';
  throw new Error(outcome.message + can);
}

export async function decode(bytes) {
  decoder ??= createDecoder({ files: modules }).catch((error) => {
    decoder = undefined; // the next one tries again
    throw error;
  });
  return check(await (await decoder).decode(bytes));
}

/** { info, display, bytes, order } of a stream; `frame`: of the original; `order`: the encoder's; `about`: goes to the info. */
export async function resultOf({ bytes, order }, frame, about = {}) {
  const begin = performance.now();
  const decoded = await decode(bytes);
  const decodeMilliseconds = performance.now() - begin;
  const { geometry, vertexCount, triangleCount, quality, chunks } = decoded;
  const attributes = decoded.attributes.map(({ values, ...rest }) => rest);
  const info = { geometry, vertexCount, triangleCount, quality, attributes, chunks, decodeMilliseconds, ...about };
  return { bytes, order, info, display: displayOf(decoded, frame) };
}
