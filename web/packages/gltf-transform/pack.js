// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// From a document's meshes to streams, one for each mesh, with accessors that stand for what is in them.
import { PropertyType } from '@gltf-transform/core';

import { streamOptions, stretchOf } from './bounds.js';
import { Contents, Merged, columnsOf } from './merge.js';

const TRIANGLES = 4;
/** About what JSON grows by: of a primitive, of an attribute beside its name; what goes with a buffer view. */
const EXTENSION_TEXT = 64;
const ATTRIBUTE_TEXT = 6;
const VIEW_TEXT = 50;

function accessorsOf(primitive) {
  return [...columnsOf(primitive).map(({ accessor }) => accessor), ...(primitive.getIndices() ? [primitive.getIndices()] : [])];
}

/** Whether all that is compressed is floats for positions, and used by nothing but primitives that are compressed too. */
function canPack(primitive) {
  const positions = primitive.getAttribute('POSITION');
  if (primitive.getMode() !== TRIANGLES) return false;
  if (!(positions?.getArray() instanceof Float32Array) || positions.getNormalized()) return false;
  if ((primitive.getIndices() ?? positions).getCount() < 3) return false;
  return columnsOf(primitive).every(({ accessor }) => accessor.getCount() === positions.getCount());
}

function primitivesToPack(document) {
  const primitives = document.getRoot().listMeshes().flatMap((mesh) => mesh.listPrimitives());
  let packed = new Set(primitives.filter(canPack));
  for (let size = -1; size !== packed.size; ) {
    size = packed.size;
    const isOurs = (parent) =>
      parent.propertyType === PropertyType.ROOT ||
      (parent.propertyType === PropertyType.PRIMITIVE && packed.has(parent)) ||
      (parent.propertyType === PropertyType.PRIMITIVE_TARGET && parent.listParents().every(isOurs));
    packed = new Set([...packed].filter((primitive) => accessorsOf(primitive).every((a) => a.listParents().every(isOurs))));
  }
  return packed;
}

/** As arrays of indices: the narrowest type whose largest value is no index. */
function indexType(vertexCount) {
  if (vertexCount <= 255) return 5121;
  return vertexCount <= 65535 ? 5123 : 5125;
}

/** Least and largest of each component. */
function boundsOf(values, components) {
  const min = new Array(components).fill(Infinity);
  const max = new Array(components).fill(-Infinity);
  values.forEach((value, i) => {
    min[i % components] = Math.min(min[i % components], value);
    max[i % components] = Math.max(max[i % components], value);
  });
  return { min, max };
}

/** Accessors of what a stream decodes to, made when they are asked for. */
class StandIns {
  #numbers = new Map();

  constructor(context, mesh) {
    this.context = context;
    this.mesh = mesh;
  }

  #add(key, accessor, definition) {
    const { accessors } = this.context.jsonDoc.json;
    if (!this.#numbers.has(key)) this.#numbers.set(key, accessors.push({ ...definition() }) - 1);
    if (accessor) this.context.accessorIndexMap.set(accessor, this.#numbers.get(key));
    return this.#numbers.get(key);
  }

  indices(accessor, group) {
    const { indices, groups, vertexCount } = this.mesh;
    return this.#add(`group ${group}`, accessor, () => ({
      type: 'SCALAR',
      componentType: indexType(vertexCount),
      count: groups ? 3 * groups.reduce((count, other) => count + (other === group), 0) : indices.length,
    }));
  }

  positions(accessor) {
    return this.#add('POSITION', accessor, () => ({
      type: 'VEC3',
      componentType: 5126,
      count: this.mesh.vertexCount,
      ...boundsOf(this.mesh.positions, 3),
    }));
  }

  attribute(accessor, number, isDisplacement) {
    return this.#add(`attribute ${number}`, accessor, () => ({
      type: accessor.getType(),
      componentType: accessor.getComponentType(),
      count: this.mesh.vertexCount,
      ...(accessor.getNormalized() ? { normalized: true } : {}),
      ...(isDisplacement ? boundsOf(this.mesh.attributes[number].values, accessor.getElementSize()) : {}),
    }));
  }
}

/** What write() puts into the primitive's definition. */
function describe(primitive, group, merged, standIns) {
  const columns = columnsOf(primitive);
  const accessors = { attributes: {}, indices: standIns.indices(primitive.getIndices(), group), mode: TRIANGLES };
  const attributes = {};
  const targets = primitive.listTargets().map(() => ({}));
  if (targets.length > 0) accessors.targets = primitive.listTargets().map(() => ({}));
  for (const column of columns) {
    const { semantic, target, accessor } = column;
    if (semantic === 'POSITION' && target === null) {
      accessors.attributes.POSITION = standIns.positions(accessor);
      continue;
    }
    const number = merged.keys.indexOf(merged.keyOf(columns, column));
    const standIn = standIns.attribute(accessor, number, target !== null && semantic === 'POSITION');
    (target === null ? attributes : targets[target])[semantic] = number;
    (target === null ? accessors.attributes : accessors.targets[target])[semantic] = standIn;
  }
  const extension = {
    ...(group > 0 ? { group } : {}),
    ...(Object.keys(attributes).length > 0 ? { attributes } : {}),
    ...(targets.length > 0 ? { targets } : {}),
  };
  return { accessors, extension };
}

/** Whether the asset gets smaller by the stream. */
function pays(primitives, streamBytes, contents) {
  const plain = new Set();
  let packed = streamBytes + VIEW_TEXT;
  for (const primitive of primitives) {
    for (const accessor of accessorsOf(primitive)) plain.add(contents.of(accessor));
    packed += EXTENSION_TEXT;
    for (const { semantic, target } of columnsOf(primitive))
      if (semantic !== 'POSITION' || target !== null) packed += ATTRIBUTE_TEXT + semantic.length;
  }
  return packed < [...plain].reduce((sum, { bytes }) => sum + bytes.length + VIEW_TEXT, 0);
}

/** What stands for the primitives, in their order; nothing where that would take more bytes. */
function packTogether(primitives, document, context, { options, encode, contents }) {
  const merged = new Merged(primitives, contents);
  const mesh = merged.mesh(options);
  const measure = (other, trial) => encode(other, trial).maxError;
  const wanted = streamOptions(options, mesh, stretchOf(primitives, document.getGraph()), measure);
  const { bytes, decoded } = encode(mesh, { ...wanted, keepUnreferenced: true });
  if (!pays(primitives, bytes.length, contents)) return null;
  const standIns = new StandIns(context, decoded);
  return primitives.map((primitive, group) => ({ bytes, ...describe(primitive, group, merged, standIns) }));
}

/** What is packed, by primitive, as `options` ask. Meshes of equal arrays share a stream. `encode`: from a mesh and options to bytes. */
export function packMeshes(document, context, options, encode) {
  const toPack = primitivesToPack(document);
  const contents = new Contents();
  const packed = new Map();
  const streams = [];
  for (const mesh of document.getRoot().listMeshes()) {
    const primitives = mesh.listPrimitives().filter((primitive) => toPack.has(primitive) && !packed.has(primitive));
    if (primitives.length === 0) continue;
    const keyOf = (primitive) => [
      primitive.getIndices() && contents.of(primitive.getIndices()),
      ...columnsOf(primitive).flatMap(({ semantic, target, accessor }) => [semantic, target, contents.of(accessor)]),
    ];
    const key = primitives.flatMap(keyOf);
    let stream = streams.find((other) => other.key.length === key.length && other.key.every((one, i) => one === key[i]));
    if (!stream) {
      stream = { key, primitives, parts: packTogether(primitives, document, context, { options, encode, contents }) };
      streams.push(stream);
      if (stream.parts === null) continue;
      const buffer = primitives[0].getAttribute('POSITION').getBuffer() ?? document.getRoot().listBuffers()[0];
      if (!context.otherBufferViews.has(buffer)) context.otherBufferViews.set(buffer, []);
      context.otherBufferViews.get(buffer).push(stream.parts[0].bytes);
    }
    if (stream.parts === null) continue;
    primitives.forEach((primitive, group) => {
      packed.set(primitive, stream.parts[group]);
      const others = accessorsOf(stream.primitives[group]);
      accessorsOf(primitive).forEach((accessor, i) => context.accessorIndexMap.set(accessor, context.accessorIndexMap.get(others[i])));
    });
  }
  return packed;
}
