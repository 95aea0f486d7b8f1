// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Draco's encoder, as `draco_encoder -cl 7` has it, and its decoder.
import createDecoderModule from 'draco3d/draco_decoder_nodejs.js';

import { boxOf, fewestBits, latticeError } from '../viewer/src/peers/quantize.js';

const SPEED = 10 - 7;
/** Bits of attributes: glTF-Transform's defaults. */
const BITS = { NORMAL: 10, TEX_COORD: 12, GENERIC: 12, COLOR: 8 };
const TYPES = { normal: 'NORMAL', uv: 'TEX_COORD', color: 'COLOR' };
const MOST_BITS = 30;

const ADD = {
  Float32Array: 'AddFloatAttribute',
  Uint8Array: 'AddUInt8Attribute',
  Uint16Array: 'AddUInt16Attribute',
};

/** `maxError`: of positions, which get the fewest bits that keep it. `module`: of draco3d's encoder. */
export function encodeDraco(module, mesh, maxError) {
  const { positions, indices, attributes } = mesh;
  const count = positions.length / 3;
  const encoder = new module.Encoder();
  const builder = new module.MeshBuilder();
  const draco = new module.Mesh();
  const output = new module.DracoInt8Array();
  builder.AddFacesToMesh(draco, indices.length / 3, indices);
  builder.AddFloatAttributeToMesh(draco, module.POSITION, count, 3, positions);
  for (const { kind, components, values } of attributes)
    builder[ADD[values.constructor.name]](draco, module[TYPES[kind] ?? 'GENERIC'], count, components, values);
  encoder.SetSpeedOptions(SPEED, SPEED);
  encoder.SetEncodingMethod(module.MESH_EDGEBREAKER_ENCODING);
  const box = boxOf(positions, 3);
  const bits = fewestBits((n) => latticeError(positions, box, 2 ** n - 1), maxError, 1, MOST_BITS);
  encoder.SetAttributeQuantization(module.POSITION, bits);
  for (const [type, n] of Object.entries(BITS)) encoder.SetAttributeQuantization(module[type], n);
  const size = encoder.EncodeMeshToDracoBuffer(draco, output);
  if (size <= 0) throw new Error('Draco could not encode this mesh');
  const bytes = Uint8Array.from({ length: size }, (_, i) => output.GetValue(i));
  for (const object of [output, draco, builder, encoder]) module.destroy(object);
  return bytes;
}

function copyOut(module, bytes, Array, fill) {
  const address = module._malloc(bytes);
  fill(address);
  const values = new Array(module.HEAPU8.slice(address, address + bytes).buffer);
  module._free(address);
  return values;
}

/** A function that decodes, as DRACOLoader of three.js does; `memoryBytes()`: of its module. */
export async function openDraco(wasmBinary) {
  const module = await createDecoderModule({ wasmBinary });
  const arrays = {
    [module.DT_UINT8]: Uint8Array,
    [module.DT_UINT16]: Uint16Array,
    [module.DT_FLOAT32]: Float32Array,
  };
  const decode = (bytes) => {
    const decoder = new module.Decoder();
    const mesh = new module.Mesh();
    const status = decoder.DecodeArrayToMesh(bytes, bytes.byteLength, mesh);
    if (!status.ok()) throw new Error(status.error_msg());
    const size = 12 * mesh.num_faces();
    const decoded = [copyOut(module, size, Uint32Array, (at) => decoder.GetTrianglesUInt32Array(mesh, size, at))];
    for (let i = 0; i < mesh.num_attributes(); ++i) {
      const attribute = decoder.GetAttribute(mesh, i);
      const type = attribute.data_type();
      const bytesOf = mesh.num_points() * attribute.num_components() * arrays[type].BYTES_PER_ELEMENT;
      decoded.push(
        copyOut(module, bytesOf, arrays[type], (at) =>
          decoder.GetAttributeDataArrayForAllPoints(mesh, attribute, type, bytesOf, at),
        ),
      );
    }
    module.destroy(mesh);
    module.destroy(decoder);
    return decoded;
  };
  return Object.assign(decode, { memoryBytes: () => module.HEAPU8.byteLength });
}
