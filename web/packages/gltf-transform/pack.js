// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// From a document's meshes to streams, one for each mesh, with accessors that stand for what is in them.
import { PropertyType } from '@gltf-transform/core';

const TRIANGLES = 4;
const KINDS = { NORMAL: 'normal', TANGENT: 'tangent', TEXCOORD: 'uv', COLOR: 'color', JOINTS: 'joints', WEIGHTS: 'weights' };

function kindOf(semantic, accessor) {
  const kind = KINDS[semantic.split('_')[0]] ?? 'generic';
  const isFloat = accessor.getArray() instanceof Float32Array;
  return (kind === 'normal' || kind === 'tangent' || kind === 'uv') && !isFloat ? 'generic' : kind;
}

/** Every array of a primitive that a stream can hold, by name: of its attributes, and of its morph targets as "0/NORMAL". */
function columnsOf(primitive) {
  const columns = new Map();
  for (const semantic of primitive.listSemantics()) columns.set(semantic, primitive.getAttribute(semantic));
  for (const [t, target] of primitive.listTargets().entries())
    for (const semantic of target.listSemantics()) columns.set(`${t}/${semantic}`, target.getAttribute(semantic));
  return columns;
}

function accessorsOf(primitive) {
  return [primitive.getIndices(), ...columnsOf(primitive).values()];
}

/** Whether all that is compressed is floats for positions, and used by nothing but primitives that are compressed too. */
function canPack(primitive) {
  const positions = primitive.getAttribute('POSITION');
  if (!primitive.getIndices() || primitive.getMode() !== TRIANGLES) return false;
  if (!(positions?.getArray() instanceof Float32Array) || positions.getNormalized()) return false;
  if (primitive.getIndices().getCount() === 0) return false;
  return [...columnsOf(primitive).values()].every((accessor) => accessor.getCount() === positions.getCount());
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

/** Two columns of one name and type are one attribute of the stream. */
function columnKey(name, accessor) {
  return [name, accessor.getArray().constructor.name, accessor.getElementSize(), accessor.getNormalized()].join(' ');
}

/** All primitives of a mesh as one, each a group; those with the same arrays share vertices. */
class Merged {
  #vertices = 0;
  #blocks = new Map();
  #columns = new Map();
  #positions = [];
  #indices = [];
  #groups = [];

  add(primitive, group) {
    const columns = columnsOf(primitive);
    const first = this.#placeOf(columns);
    const indices = primitive.getIndices().getArray();
    for (const index of indices) this.#indices.push(first + index);
    for (let face = 0; face < indices.length / 3; ++face) this.#groups.push(group);
  }

  #placeOf(columns) {
    const block = [...columns.values()];
    const known = [...this.#blocks.keys()].find((other) => other.length === block.length && other.every((a, i) => a === block[i]));
    if (known) return this.#blocks.get(known);
    const first = this.#vertices;
    this.#blocks.set(block, first);
    this.#vertices += columns.get('POSITION').getCount();
    this.#positions.push([first, columns.get('POSITION')]);
    for (const [name, accessor] of columns) {
      if (name === 'POSITION') continue;
      const key = columnKey(name, accessor);
      if (!this.#columns.has(key)) this.#columns.set(key, { name, accessor, parts: [] });
      this.#columns.get(key).parts.push([first, accessor]);
    }
    return first;
  }

  #valuesOf(Array, components, parts) {
    const values = new Array(this.#vertices * components);
    for (const [first, accessor] of parts) values.set(accessor.getArray(), first * components);
    return values;
  }

  keys() {
    return [...this.#columns.keys()];
  }

  mesh() {
    return {
      positions: this.#valuesOf(Float32Array, 3, this.#positions),
      indices: Uint32Array.from(this.#indices),
      groups: this.#groups.at(-1) > 0 ? this.#groups : null,
      attributes: [...this.#columns.values()].map(({ name, accessor, parts }) => ({
        name,
        kind: name.includes('/') ? 'generic' : kindOf(name, accessor),
        components: accessor.getElementSize(),
        normalized: accessor.getNormalized(),
        linear: !name.includes('/') && kindOf(name, accessor) === 'color',
        values: this.#valuesOf(accessor.getArray().constructor, accessor.getElementSize(), parts),
      })),
    };
  }
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
    this.context.accessorIndexMap.set(accessor, this.#numbers.get(key));
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
function describe(primitive, group, keys, standIns) {
  const accessors = { attributes: {}, indices: standIns.indices(primitive.getIndices(), group), mode: TRIANGLES };
  const attributes = {};
  const targets = primitive.listTargets().map(() => ({}));
  if (targets.length > 0) accessors.targets = primitive.listTargets().map(() => ({}));
  for (const [name, accessor] of columnsOf(primitive)) {
    const number = keys.indexOf(columnKey(name, accessor));
    const [target, semantic] = name.includes('/') ? name.split('/') : [null, name];
    if (target !== null) {
      targets[target][semantic] = number;
      accessors.targets[target][semantic] = standIns.attribute(accessor, number, semantic === 'POSITION');
    } else if (name === 'POSITION') {
      accessors.attributes.POSITION = standIns.positions(accessor);
    } else {
      attributes[name] = number;
      accessors.attributes[name] = standIns.attribute(accessor, number, false);
    }
  }
  const extension = {
    ...(group > 0 ? { group } : {}),
    ...(Object.keys(attributes).length > 0 ? { attributes } : {}),
    ...(targets.length > 0 ? { targets } : {}),
  };
  return { accessors, extension };
}

/** What stands for the primitives, in their order. `encode`: from a mesh to its stream's bytes and what they decode to. */
function packTogether(primitives, context, encode) {
  const merged = new Merged();
  primitives.forEach((primitive, group) => merged.add(primitive, group));
  const { bytes, mesh } = encode(merged.mesh());
  const standIns = new StandIns(context, mesh);
  return primitives.map((primitive, group) => ({ bytes, ...describe(primitive, group, merged.keys(), standIns) }));
}

/** What is packed, by primitive. Meshes of the same arrays, as those of other materials are, share a stream. */
export function packMeshes(document, context, encode) {
  const toPack = primitivesToPack(document);
  const packed = new Map();
  const streams = [];
  for (const mesh of document.getRoot().listMeshes()) {
    const primitives = mesh.listPrimitives().filter((primitive) => toPack.has(primitive) && !packed.has(primitive));
    if (primitives.length === 0) continue;
    const key = primitives.flatMap((primitive) => [primitive.getIndices(), ...[...columnsOf(primitive)].flat()]);
    let stream = streams.find((other) => other.key.length === key.length && other.key.every((one, i) => one === key[i]));
    if (!stream) {
      stream = { key, parts: packTogether(primitives, context, encode) };
      streams.push(stream);
      const buffer = primitives[0].getAttribute('POSITION').getBuffer() ?? document.getRoot().listBuffers()[0];
      if (!context.otherBufferViews.has(buffer)) context.otherBufferViews.set(buffer, []);
      context.otherBufferViews.get(buffer).push(stream.parts[0].bytes);
    }
    primitives.forEach((primitive, group) => packed.set(primitive, stream.parts[group]));
  }
  return packed;
}
