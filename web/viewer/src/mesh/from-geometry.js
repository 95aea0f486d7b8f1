// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Geometries of three.js become meshes that the encoder takes.
import { Color, SRGBColorSpace } from 'three';

import { pickRows, weld } from './weld.js';

/** Attributes of three.js that are kept, with what the encoder calls them. */
const KEPT = {
  normal: { kind: 'normal', name: 'NORMAL', components: 3 },
  uv: { kind: 'uv', name: 'TEXCOORD_0', components: 2 },
  tangent: { kind: 'tangent', name: 'TANGENT', components: 4 },
};

export function floatsOf(attribute, components) {
  const values = new Float32Array(attribute.count * components);
  for (let i = 0; i < attribute.count; ++i) {
    for (let c = 0; c < components; ++c) values[i * components + c] = attribute.getComponent(i, c);
  }
  return values;
}

/** The bytes that a file had before three.js made linear numbers of them. */
function bytesOfColors(attribute) {
  const values = new Uint8Array(attribute.count * 3);
  const color = new Color();
  const bytes = {};
  for (let i = 0; i < attribute.count; ++i) {
    color.fromBufferAttribute(attribute, i).getRGB(bytes, SRGBColorSpace);
    values.set([Math.round(bytes.r * 255), Math.round(bytes.g * 255), Math.round(bytes.b * 255)], 3 * i);
  }
  return values;
}

function colorOf(attribute, isLinear) {
  if (!isLinear) return { kind: 'color', name: 'color', components: 3, normalized: true, values: bytesOfColors(attribute) };
  const components = attribute.itemSize;
  const values = floatsOf(attribute, components);
  const isBytes = attribute.array instanceof Uint8Array;
  return {
    kind: 'color',
    name: 'COLOR_0',
    components,
    normalized: isBytes,
    linear: true,
    values: isBytes ? Uint8Array.from(values, (value) => Math.round(value * 255)) : values,
  };
}

/** `isLinear`: colours are, as glTF's. Of a geometry without index also `corners`: the mesh's vertex for each of the geometry's. */
export function meshOfGeometry(geometry, { isLinear = false } = {}) {
  const { position, color } = geometry.attributes;
  const positions = floatsOf(position, 3);
  const attributes = [];
  for (const [key, info] of Object.entries(KEPT)) {
    const attribute = geometry.attributes[key];
    if (attribute) attributes.push({ ...info, normalized: false, values: floatsOf(attribute, info.components) });
  }
  if (color) attributes.push(colorOf(color, isLinear));
  if (geometry.index) return { positions, indices: Uint32Array.from(geometry.index.array), groups: null, attributes };
  return weldCorners({ positions, attributes });
}

/** Of a mesh whose corners have a vertex each. */
function weldCorners({ positions, attributes }) {
  const count = positions.length / 3;
  const { rows, numbers } = weld([{ values: positions, components: 3 }, ...attributes], count);
  return {
    positions: pickRows(positions, 3, rows),
    indices: numbers.slice(0, 3 * Math.floor(count / 3)),
    corners: numbers,
    groups: null,
    attributes: attributes.map((a) => ({ ...a, values: pickRows(a.values, a.components, rows) })),
  };
}
