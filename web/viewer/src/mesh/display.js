// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// What the graphics card gets of a mesh: arrays near its origin. For workers.
import { toLinear } from './colors.js';
import { creasedNormals, hasCreases, withCopies } from './creases.js';
import { vertexNormals } from './normals.js';

/** Centre and diagonal of the bounding box; `isCreased`: whether sharp edges are shown as such, see hasCreases(). */
export function frameOf({ positions, indices, attributes }) {
  const min = [Infinity, Infinity, Infinity];
  const max = [-Infinity, -Infinity, -Infinity];
  for (let i = 0; i < positions.length; i += 3) {
    for (let axis = 0; axis < 3; ++axis) {
      const value = positions[i + axis];
      if (value < min[axis]) min[axis] = value;
      if (value > max[axis]) max[axis] = value;
    }
  }
  const diagonal = Math.hypot(...max.map((value, axis) => value - min[axis]));
  const isCreased = !ownNormals(attributes) && hasCreases(positions, indices);
  return { center: max.map((value, axis) => (value + min[axis]) / 2), diagonal, isCreased };
}

/** n x 4, 16 bits, linear. */
function displayColors({ linear, components, values }, count) {
  const colors = new Uint16Array(4 * count).fill(65535);
  const largest = values instanceof Float32Array ? 1 : 2 ** (8 * values.BYTES_PER_ELEMENT) - 1;
  for (let i = 0; i < count; ++i) {
    for (let c = 0; c < Math.min(components, 3); ++c) {
      const share = Math.min(1, Math.max(0, values[i * components + c] / largest));
      colors[4 * i + c] = 65535 * (linear ? share : toLinear(share));
    }
  }
  return colors;
}

/** Faces of a group together; `ranges`: { group, start, count } in corners, or null where there is one group. */
function facesByGroup(indices, groups) {
  if (!groups) return { indices: indices.slice(), ranges: null };
  const counts = [];
  for (const group of groups) counts[group] = (counts[group] ?? 0) + 3;
  const ranges = [];
  const next = [];
  for (let group = 0, at = 0; group < counts.length; ++group) {
    if (!counts[group]) continue;
    ranges.push({ group, start: at, count: counts[group] });
    next[group] = at;
    at += counts[group];
  }
  const sorted = new Uint32Array(indices.length);
  for (let i = 0; i < indices.length; ++i) sorted[next[groups[Math.floor(i / 3)]]++] = indices[i];
  return { indices: sorted, ranges };
}

/** With those vertices added that sharp edges need: `copies`, for each its vertex. */
function creased({ positions, indices, normals, uvs, colors, ...rest }) {
  const { copies, ...made } = creasedNormals(positions, indices);
  const all = (values, components) => values && withCopies(values, components, copies);
  return { ...rest, ...made, copies, positions: all(positions, 3), uvs: all(uvs, 2), colors: all(colors, 4) };
}

const ownNormals = (attributes) => attributes.find(({ kind, values }) => kind === 'normal' && values instanceof Float32Array);

/** `frame`: of the original. Arrays of its own. */
export function displayOf({ positions, indices, groups, attributes }, frame) {
  const near = new Float32Array(positions.length);
  for (let i = 0; i < positions.length; ++i) near[i] = positions[i] - frame.center[i % 3];
  const color = attributes.find(({ kind, components }) => kind === 'color' && components >= 3);
  const own = ownNormals(attributes);
  const display = {
    positions: near,
    ...facesByGroup(indices, groups),
    uvs: attributes.find(({ kind, components, values }) => kind === 'uv' && components === 2 && values instanceof Float32Array)?.values.slice() ?? null,
    normals: own ? own.values.slice() : frame.isCreased ? null : vertexNormals(near, indices),
    copies: null,
    colors: color ? displayColors(color, positions.length / 3) : null,
  };
  return display.normals ? display : creased(display);
}

export function buffersOf(display) {
  return Object.values(display).flatMap((array) => (ArrayBuffer.isView(array) ? [array.buffer] : []));
}
