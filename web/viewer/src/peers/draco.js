// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Draco at largest errors: the fewest bits that keep them, level 10 (speed 0).
import createEncoderModule from 'draco3d/draco_encoder_nodejs.js';

import { boxOf, fewestBits, latticeError, levelsOf, octahedronError } from './quantize.js';

const MOST_BITS = 30;
let module;

async function load() {
  const response = await fetch(new URL('./draco_encoder.wasm', import.meta.url));
  return createEncoderModule({ wasmBinary: await response.arrayBuffer() });
}

function latticeBits(values, components, bound) {
  const box = boxOf(values, components);
  // No row is off by more than half a cell's diagonal; most meshes come near it, so fewer bits need not be tried.
  const least = Math.max(1, Math.floor(Math.log2(box.side / bound)) - 2) || 1;
  return fewestBits((bits) => latticeError(values, box, 2 ** bits - 1), bound, Math.min(least, MOST_BITS), MOST_BITS);
}

function addAttribute(draco, { builder, mesh, encoder }, { kind, components, values, error }) {
  const count = values.length / components;
  if (kind === 'color') {
    builder.AddUInt8Attribute(mesh, draco.COLOR, count, components, levelsOf(values, error));
    return;
  }
  const type = kind === 'normal' ? draco.NORMAL : draco.TEX_COORD;
  builder.AddFloatAttributeToMesh(mesh, type, count, components, values);
  const bits = kind === 'normal' ? fewestBits((n) => octahedronError(values, n), error, 2, MOST_BITS) : latticeBits(values, 2, error);
  encoder.SetAttributeQuantization(type, bits);
}

export function encodeAt(draco, { positions, indices, attributes }, bits) {
  const encoder = new draco.Encoder();
  const builder = new draco.MeshBuilder();
  const mesh = new draco.Mesh();
  const output = new draco.DracoInt8Array();
  builder.AddFacesToMesh(mesh, indices.length / 3, indices);
  builder.AddFloatAttributeToMesh(mesh, draco.POSITION, positions.length / 3, 3, positions);
  encoder.SetSpeedOptions(0, 0);
  encoder.SetEncodingMethod(draco.MESH_EDGEBREAKER_ENCODING);
  encoder.SetAttributeQuantization(draco.POSITION, bits);
  for (const attribute of attributes) addAttribute(draco, { builder, mesh, encoder }, attribute);
  const bytes = encoder.EncodeMeshToDracoBuffer(mesh, output);
  for (const object of [output, mesh, builder, encoder]) draco.destroy(object);
  if (bytes <= 0) throw new Error('Draco could not encode this mesh');
  return { bits, bytes, error: latticeError(positions, boxOf(positions, 3), 2 ** bits - 1) };
}

/** Around the request's largest error, from coarse to fine: { bits, bytes, error }. `request`: of requestOf(). */
export async function dracoPoints(request) {
  const draco = await (module ??= load());
  const bits = latticeBits(request.positions, 3, request.maxError);
  return [bits - 1, bits, bits + 1].filter((each) => each >= 1 && each <= MOST_BITS).map((each) => encodeAt(draco, request, each));
}
