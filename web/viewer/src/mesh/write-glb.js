// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// A decoded mesh as GLB, with its attributes and a primitive for each group.

import { toLinear } from './colors.js';

const COMPONENT_TYPES = new Map([
  [Int8Array, 5120], [Uint8Array, 5121], [Int16Array, 5122], [Uint16Array, 5123], [Uint32Array, 5125], [Float32Array, 5126],
]);
const TYPES = { 1: 'SCALAR', 2: 'VEC2', 3: 'VEC3', 4: 'VEC4' };
const NAMES = { normal: 'NORMAL', tangent: 'TANGENT', color: 'COLOR', uv: 'TEXCOORD' };
const ARRAY_BUFFER = 34962;
const ELEMENT_ARRAY_BUFFER = 34963;

const padded = (size) => Math.ceil(size / 4) * 4;

/** Rows that begin at multiples of 4 bytes. */
function alignRows(values, components) {
  const row = components * values.BYTES_PER_ELEMENT;
  if (row % 4 === 0) return { values, stride: row };
  const stride = padded(row);
  const step = stride / values.BYTES_PER_ELEMENT;
  const aligned = new values.constructor((values.length / components) * step);
  for (let i = 0; i < values.length; ++i) aligned[Math.floor(i / components) * step + (i % components)] = values[i];
  return { values: aligned, stride };
}

class Buffers {
  json = { bufferViews: [], accessors: [] };
  parts = [];
  size = 0;

  add(values, components, { target, normalized = false, bounds = {} }) {
    const isVertex = target === ARRAY_BUFFER;
    const { values: rows, stride } = isVertex ? alignRows(values, components) : { values };
    this.json.bufferViews.push({
      buffer: 0,
      byteOffset: this.size,
      byteLength: rows.byteLength,
      target,
      ...(isVertex ? { byteStride: stride } : {}),
    });
    this.parts.push({ at: this.size, bytes: new Uint8Array(rows.buffer, rows.byteOffset, rows.byteLength) });
    this.size += padded(rows.byteLength);
    return this.json.accessors.push({
      bufferView: this.json.bufferViews.length - 1,
      componentType: COMPONENT_TYPES.get(values.constructor),
      count: values.length / components,
      type: TYPES[components],
      ...(normalized ? { normalized } : {}),
      ...bounds,
    }) - 1;
  }
}

function boundsOf(positions) {
  const min = [Infinity, Infinity, Infinity];
  const max = [-Infinity, -Infinity, -Infinity];
  positions.forEach((value, i) => {
    min[i % 3] = Math.min(min[i % 3], value);
    max[i % 3] = Math.max(max[i % 3], value);
  });
  return { min, max };
}

/** glTF's colours are linear: numbers of 16 bits, where the source's are bytes or 16 bits. Alpha stays as it is. */
function linearColors({ values, components }) {
  const isFloat = values instanceof Float32Array;
  const largest = isFloat ? 1 : 2 ** (8 * values.BYTES_PER_ELEMENT) - 1;
  const linear = Float64Array.from(values, (value, i) => (i % components === 3 ? value / largest : toLinear(value / largest)));
  return isFloat ? Float32Array.from(linear) : Uint16Array.from(linear, (value) => Math.round(65535 * value));
}

function semantics(attributes) {
  const numbers = {};
  return attributes.flatMap((attribute) => {
    const base = NAMES[attribute.kind];
    const isNumbered = attribute.kind === 'color' || attribute.kind === 'uv';
    if (!base || !COMPONENT_TYPES.has(attribute.values.constructor)) return [];
    const number = (numbers[base] = (numbers[base] ?? -1) + 1);
    if (!isNumbered && number > 0) return [];
    // Colours of bytes stand for parts of 1 in glTF, whatever the source says.
    const normalized = attribute.normalized || (isNumbered && !(attribute.values instanceof Float32Array));
    const values = attribute.kind === 'color' && !attribute.linear ? linearColors(attribute) : attribute.values;
    return [{ ...attribute, values, normalized, semantic: isNumbered ? `${base}_${number}` : base }];
  });
}

function facesOf({ indices, groups }) {
  if (!groups) return [indices];
  const faces = [];
  groups.forEach((group, face) => (faces[group] ??= []).push(indices[3 * face], indices[3 * face + 1], indices[3 * face + 2]));
  return faces.filter(Boolean).map((corners) => Uint32Array.from(corners));
}

/** The origin becomes the node's translation. Joints, weights and generic attributes are left out. */
export function writeGlb(mesh) {
  const buffers = new Buffers();
  const target = ARRAY_BUFFER;
  const attributes = { POSITION: buffers.add(mesh.positions, 3, { target, bounds: boundsOf(mesh.positions) }) };
  for (const { semantic, values, components, normalized } of semantics(mesh.attributes)) {
    attributes[semantic] = buffers.add(values, components, { target, normalized });
  }
  const primitives = facesOf(mesh).map((indices) => ({
    attributes,
    indices: buffers.add(indices, 1, { target: ELEMENT_ARRAY_BUFFER }),
  }));
  const isMoved = mesh.origin.some((value) => value !== 0);
  const json = {
    asset: { version: '2.0', generator: 'deltamesh viewer' },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0, ...(isMoved ? { translation: mesh.origin } : {}) }],
    meshes: [{ primitives }],
    buffers: [{ byteLength: buffers.size }],
    ...buffers.json,
  };
  const text = new TextEncoder().encode(JSON.stringify(json));
  const textSize = padded(text.length);
  const glb = new Uint8Array(12 + 8 + textSize + 8 + buffers.size);
  const view = new DataView(glb.buffer);
  [0x46546c67, 2, glb.length, textSize, 0x4e4f534a].forEach((word, i) => view.setUint32(4 * i, word, true));
  glb.fill(0x20, 20, 20 + textSize);
  glb.set(text, 20);
  view.setUint32(20 + textSize, buffers.size, true);
  view.setUint32(24 + textSize, 0x004e4942, true);
  for (const { at, bytes } of buffers.parts) glb.set(bytes, 28 + textSize + at);
  return glb;
}
