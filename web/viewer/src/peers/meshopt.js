// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// meshoptimizer at largest errors: lattices as coarse as these allow, its codecs, and deflate.
import { MeshoptEncoder } from 'meshoptimizer/encoder';

import { boxOf, fewestBits, latticeError, levelsOf, octahedronError } from './quantize.js';

const MOST_OF_16_BITS = 65535;

/** As coarse as the error allows; finer by hundredths where a row is too far off. */
function stepsFor(values, box, bound) {
  let steps = Math.max(1, Math.floor((box.side * Math.sqrt(box.min.length)) / (2 * bound) / 1.2));
  while (steps < 2 ** 24 && latticeError(values, box, steps) > bound) steps = Math.ceil(steps * 1.01);
  return steps;
}

/** Rows of multiples of four bytes, as glTF has them. */
function latticeRows(values, components, bound) {
  const box = boxOf(values, components);
  const steps = stepsFor(values, box, bound);
  const width = steps <= MOST_OF_16_BITS ? 2 * Math.ceil(components / 2) : components;
  const rows = new (steps <= MOST_OF_16_BITS ? Uint16Array : Uint32Array)((values.length / components) * width);
  const scale = steps / (box.side || 1);
  for (let i = 0; i < values.length; ++i) {
    const axis = i % components;
    rows[Math.floor(i / components) * width + axis] = Math.floor((values[i] - box.min[axis]) * scale + 0.5);
  }
  return { rows, width, steps, error: latticeError(values, box, steps) };
}

function normalRows(values, bound) {
  const bits = fewestBits((n) => octahedronError(values, n), bound, 4, 16);
  const four = new Float32Array((values.length / 3) * 4);
  for (let i = 0; i < values.length; ++i) four[4 * Math.floor(i / 3) + (i % 3)] = values[i];
  const stride = bits <= 8 ? 4 : 8;
  return { rows: MeshoptEncoder.encodeFilterOct(four, values.length / 3, stride, bits), width: stride };
}

function colorRows(values, components, bound) {
  const rows = new Uint8Array((values.length / components) * 4);
  levelsOf(values, bound).forEach((value, i) => (rows[4 * Math.floor(i / components) + (i % components)] = value));
  return { rows, width: 4 };
}

function rowsOf({ kind, components, values, error }) {
  if (kind === 'normal') return normalRows(values, error);
  return kind === 'uv' ? latticeRows(values, components, error) : colorRows(values, components, error);
}

/** In the order of vertices that the codec of faces wants. */
function encodeRows({ rows, width }, remap, count) {
  const ordered = new rows.constructor(width * count);
  for (let v = 0; v < remap.length; ++v) {
    if (remap[v] < count) ordered.set(rows.subarray(v * width, (v + 1) * width), remap[v] * width); // others have no face
  }
  return MeshoptEncoder.encodeVertexBuffer(new Uint8Array(ordered.buffer), count, width * rows.BYTES_PER_ELEMENT);
}

async function deflatedSize(arrays) {
  const stream = new Blob(arrays).stream().pipeThrough(new CompressionStream('deflate-raw'));
  return (await new Response(stream).arrayBuffer()).byteLength;
}

const FACTORS = [2, 1, 0.5];

/** Around the request's largest error, from coarse to fine: { steps, bytes, deflated, error }. `request`: of requestOf(). */
export async function meshoptPoints({ positions, indices, attributes, maxError }) {
  await MeshoptEncoder.ready;
  const faces = indices.slice(); // reorderMesh() writes the new order here
  const [remap, count] = MeshoptEncoder.reorderMesh(faces, true, true);
  const others = [...attributes.map((attribute) => encodeRows(rowsOf(attribute), remap, count))];
  others.push(MeshoptEncoder.encodeIndexBuffer(new Uint8Array(faces.buffer), faces.length, 4));
  const points = [];
  for (const factor of FACTORS) {
    const places = latticeRows(positions, 3, factor * maxError);
    const parts = [encodeRows(places, remap, count), ...others];
    const bytes = parts.reduce((sum, { length }) => sum + length, 0);
    points.push({ steps: places.steps, bytes, deflated: await deflatedSize(parts), error: places.error });
  }
  return points;
}
