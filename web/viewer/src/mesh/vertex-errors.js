// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Errors of every vertex of a decoded mesh, for heat maps. For workers.
import { uniqueEdges } from './edges.js';
import { vertexNormals } from './normals.js';
import { pickRows, weld } from './weld.js';

const DEGREES = 180 / Math.PI;

function dotAt(a, b, at) {
  return a[at] * b[at] + a[at + 1] * b[at + 1] + a[at + 2] * b[at + 2];
}

/**
 * S(v) of the paper's equation 2: a vertex against the mean of its neighbours, weighted by the inverse lengths of edges. n x 3,
 * doubles.
 */
function laplacians(positions, edges) {
  const sums = new Float64Array(positions.length);
  const weights = new Float64Array(positions.length / 3);
  for (let i = 0; i < edges.length; i += 2) {
    const [a, b] = [edges[i], edges[i + 1]];
    const x = positions[3 * b] - positions[3 * a];
    const y = positions[3 * b + 1] - positions[3 * a + 1];
    const z = positions[3 * b + 2] - positions[3 * a + 2];
    const length = Math.sqrt(x * x + y * y + z * z);
    const weight = length > 0 ? 1 / length : 1;
    for (const [vertex, sign] of [[3 * a, weight], [3 * b, -weight]]) {
      sums[vertex] += sign * x;
      sums[vertex + 1] += sign * y;
      sums[vertex + 2] += sign * z;
    }
    weights[a] += weight;
    weights[b] += weight;
  }
  for (let i = 0; i < sums.length; ++i) sums[i] /= -weights[Math.floor(i / 3)] || 1;
  return sums;
}

/** Length of the difference of S(v), model units. Vertices in one place count as one, as in the encoder. */
function visualErrors(original, decoded, indices) {
  const count = original.length / 3;
  const { rows, numbers } = weld([{ values: original, components: 3 }], count);
  const edges = uniqueEdges(indices, rows.length, numbers);
  const before = laplacians(pickRows(original, 3, rows), edges);
  const after = laplacians(pickRows(decoded, 3, rows), edges);
  const errors = new Float32Array(count);
  for (let v = 0; v < count; ++v) {
    const at = 3 * numbers[v];
    errors[v] = Math.hypot(after[at] - before[at], after[at + 1] - before[at + 1], after[at + 2] - before[at + 2]);
  }
  return errors;
}

const colorsOf = ({ attributes }) => attributes.find(({ kind, components }) => kind === 'color' && components >= 3);

/** Root mean square of the differences of red, green and blue, 255ths of their range; 0 without colours. */
function colorErrors(original, decoded, order) {
  const errors = new Float32Array(order.length);
  const [source, target] = [colorsOf(original), colorsOf(decoded)];
  if (!source || !target) return errors;
  const top = { Uint8Array: 255, Uint16Array: 65535 }[source.values.constructor.name] ?? 1;
  for (let v = 0; v < order.length; ++v) {
    let squares = 0;
    for (let c = 0; c < 3; ++c)
      squares += (target.values[target.components * v + c] - source.values[source.components * order[v] + c]) ** 2;
    errors[v] = (255 / top) * Math.sqrt(squares / 3);
  }
  return errors;
}

/**
 * `order`: the original's vertex for every decoded one. Returns per decoded vertex `signed`, the displacement along the original's
 * normal, outward positive; `vde`; `normal`, degrees between normals; and `tint`, of colours. The first two in model units.
 */
export function vertexErrors(original, decoded, order) {
  const count = order.length;
  const { indices } = decoded;
  const before = pickRows(original.positions, 3, order);
  const faceNormals = vertexNormals(before, indices);
  const signed = new Float32Array(count);
  for (let at = 0, v = 0; v < count; ++v, at += 3) {
    for (let i = at; i < at + 3; ++i) signed[v] += (decoded.positions[i] - before[i]) * faceNormals[i];
  }
  const own = ({ attributes }) => attributes.find(({ kind, components }) => kind === 'normal' && components === 3)?.values;
  const [source, target] = [own(original), own(decoded)];
  const hasOwn = source && target;
  const normalsBefore = hasOwn ? pickRows(source, 3, order) : faceNormals;
  const normalsAfter = hasOwn ? target : vertexNormals(decoded.positions, indices);
  const normal = new Float32Array(count);
  for (let v = 0; v < count; ++v) {
    const [a, b] = [normalsBefore, normalsAfter];
    const lengths = Math.sqrt(dotAt(a, a, 3 * v) * dotAt(b, b, 3 * v)) || 1;
    normal[v] = DEGREES * Math.acos(Math.min(1, Math.max(-1, dotAt(a, b, 3 * v) / lengths)));
  }
  const tint = colorErrors(original, decoded, order);
  return { signed, vde: visualErrors(before, decoded.positions, indices), normal, tint };
}
