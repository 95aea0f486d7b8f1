// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What modules return, as web/wasm/outcome.h has it.
import { DeltameshError } from './errors.js';

/** As outcome.h numbers them. */
export const PARTS = ['highpass', 'zstd', 'rare', 'grid'];

const WHERE = ['', 'byte', 'line', 'vertex', 'triangle', 'attribute', 'element', 'accessor', 'primitive'];
export const KINDS = ['normal', 'color', 'uv', 'generic', 'tangent', 'joints', 'weights'];
const CODECS = ['raw', 'zstd', 'compact'];
const GEOMETRIES = ['', 'highpass', 'predictive', 'grid'];
export const ARRAYS = [
  Int8Array, Uint8Array, Int16Array, Uint16Array, Int32Array, Uint32Array, Float32Array, Float64Array,
];

function tagText(tag) {
  return tag ? String.fromCharCode(tag & 255, (tag >> 8) & 255, (tag >> 16) & 255, (tag >> 24) & 255) : '';
}

/** As ErrorOutcome in outcome.h; null where there is none. */
export function readError(instance, address) {
  const [code, what, rule, whereKind] = instance.words(address, 4);
  if (code === 0) return null;
  return new DeltameshError({
    code,
    what: instance.text(what),
    rule: instance.text(rule),
    where: whereKind ? { unit: WHERE[whereKind], position: instance.doubles(address + 16, 1)[0] } : null,
    chunk: tagText(instance.words(address + 24, 1)[0]),
  });
}

/** Reads an AttributeOutcome, with the values if the stream was decoded. */
function readAttribute(instance, address, vertices, isDecoded) {
  const [name, nameBytes, kind, type, components, flags, codedBytes, values] = instance.words(address + 8, 8);
  const attribute = {
    name: instance.text(name, nameBytes),
    kind: KINDS[kind],
    components,
    normalized: (flags & 1) !== 0,
    linear: (flags & 2) !== 0,
    codedBytes,
    error: instance.doubles(address, 1)[0],
  };
  const Array = ARRAYS[type];
  if (isDecoded) attribute.values = new Array(instance.bytes(values, vertices * components * Array.BYTES_PER_ELEMENT));
  return attribute;
}

/** Reads a StreamOutcome, with the mesh if the stream was decoded. Empty arrays have address 0. */
export function readStream(instance, address, isDecoded) {
  const [geometry, parts] = instance.words(address + 32, 2);
  const [vde, lfe, maxError] = instance.doubles(address + 112, 3);
  const box = instance.doubles(address + 64, 6);
  const words = instance.words(address + 136, 10);
  const [vertexCount, triangleCount, keepsOrder, attributeCount, attributes, chunkCount, chunks] = words;
  const [positions, indices, groups] = words.slice(7);
  const stream = {
    geometry: GEOMETRIES[geometry],
    modules: PARTS.filter((_, number) => (parts >> number) & 1),
    vertexCount,
    triangleCount,
    keepsOrder: keepsOrder !== 0,
    origin: [...instance.doubles(address + 40, 3)],
    box: { min: [...box.slice(0, 3)], max: [...box.slice(3)] },
    quality: { vde, lfe, maxError },
    attributes: Array.from({ length: attributeCount }, (_, i) => readAttribute(instance, attributes + 40 * i, vertexCount, isDecoded)),
    chunks: Array.from({ length: chunkCount }, (_, i) => {
      const [tag, codec, codedBytes, decodedBytes] = instance.words(chunks + 16 * i, 4);
      return { tag: tagText(tag), codec: CODECS[codec], codedBytes, decodedBytes };
    }),
  };
  if (!isDecoded) return stream;
  stream.positions = new Float32Array(instance.bytes(positions, 12 * vertexCount));
  stream.indices = new Uint32Array(instance.bytes(indices, 12 * triangleCount));
  stream.groups = groups ? new Uint32Array(instance.bytes(groups, 4 * triangleCount)) : null;
  return stream;
}
