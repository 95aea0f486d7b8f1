// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The glTF extension DELTAMESH_mesh_compression, whatever the loader. See gltf.d.ts.
import { CODES, DeltameshError, errorIn } from './errors.js';

export { errorIn };
export const EXTENSION_NAME = 'DELTAMESH_mesh_compression';

const TRIANGLES = 4;
const INDEX_ARRAYS = { 5121: Uint8Array, 5123: Uint16Array, 5125: Uint32Array };
const ARRAYS = { 5120: Int8Array, 5122: Int16Array, 5126: Float32Array, ...INDEX_ARRAYS };
const COMPONENTS = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4 };

function check(condition, rule, what) {
  if (!condition) throw new DeltameshError({ code: CODES.invalidAsset, what, rule });
}

/** The accessors' numbers, with what each of them stands for. */
function* standIns(primitive, extension) {
  const { group = 0, attributes = {}, targets = [] } = extension;
  check((primitive.mode ?? TRIANGLES) === TRIANGLES, 'GLTF-2', 'a compressed primitive that is not triangles');
  check(
    primitive.attributes?.POSITION !== undefined && primitive.indices !== undefined,
    'GLTF-3',
    'a compressed primitive without positions or indices',
  );
  yield [primitive.attributes.POSITION, { kind: 'positions' }];
  yield [primitive.indices, { kind: 'indices', group }];
  for (const [semantic, number] of Object.entries(attributes)) {
    const fits = semantic !== 'POSITION' && primitive.attributes[semantic] !== undefined;
    check(fits, 'GLTF-4', `an attribute that the primitive does not have: ${semantic}`);
    yield [primitive.attributes[semantic], { kind: 'attribute', number }];
  }
  for (const [i, target] of targets.entries()) {
    for (const [semantic, number] of Object.entries(target)) {
      const accessor = primitive.targets?.[i]?.[semantic];
      check(accessor !== undefined, 'GLTF-4', `a morph target that the primitive does not have: ${semantic}`);
      yield [accessor, { kind: 'attribute', number }];
    }
  }
}

/** `work`'s result; what it throws is thrown as an error in `source`. */
function within(source, work) {
  try {
    return work();
  } catch (error) {
    throw errorIn(source, error);
  }
}

function findInPrimitive(json, primitive, source, found) {
  const extension = primitive.extensions[EXTENSION_NAME];
  check(json.bufferViews?.[extension.bufferView], 'GLTF-1', 'a stream in a buffer view that is not there');
  for (const [accessor, what] of standIns(primitive, extension)) {
    check(json.accessors?.[accessor], 'GLTF-5', 'an accessor that is not there');
    const standIn = { bufferView: extension.bufferView, ...what };
    const { source: first, ...other } = found.get(accessor) ?? { ...standIn, source };
    check(JSON.stringify(other) === JSON.stringify(standIn), 'GLTF-6', 'an accessor that stands for two arrays');
    found.set(accessor, { ...standIn, source: first });
  }
}

export function findCompressed(json) {
  const found = new Map();
  for (const [m, { name, primitives = [] }] of (json.meshes ?? []).entries()) {
    for (const [p, primitive] of primitives.entries()) {
      if (!primitive.extensions?.[EXTENSION_NAME]) continue;
      const source = `mesh ${m}${name ? ` (${name})` : ''}, primitive ${p}`;
      within(source, () => findInPrimitive(json, primitive, source, found));
    }
  }
  return found;
}

/** For each mesh with groups: its indices sorted by group, and where the indices of each group begin. */
const sortedMeshes = new WeakMap();

/** One pass for all of a mesh's primitives: an asset may have thousands. */
function sortByGroup({ indices, groups }) {
  const bounds = new Uint32Array(groups.reduce((most, group) => Math.max(most, group), 0) + 2);
  for (const group of groups) bounds[group + 1] += 3;
  for (let group = 1; group < bounds.length; ++group) bounds[group] += bounds[group - 1];
  const next = bounds.slice();
  const sorted = new Uint32Array(indices.length);
  for (let corner = 0; corner < indices.length; ++corner) sorted[next[groups[Math.floor(corner / 3)]]++] = indices[corner];
  return { sorted, bounds };
}

function indicesOf(mesh, group) {
  if (!mesh.groups) return group === 0 ? mesh.indices : mesh.indices.subarray(0, 0);
  if (!sortedMeshes.has(mesh)) sortedMeshes.set(mesh, sortByGroup(mesh));
  const { sorted, bounds } = sortedMeshes.get(mesh);
  return Number.isInteger(group) ? sorted.slice(bounds[group] ?? 0, bounds[group + 1] ?? 0) : new Uint32Array();
}

function fitsAccessor(accessor, components, Type, values) {
  return (
    COMPONENTS[accessor.type] === components &&
    ARRAYS[accessor.componentType] === Type &&
    accessor.count * components === values.length
  );
}

export function arrayOf(mesh, standIn, accessor) {
  return within(standIn.source, () => arrayIn(mesh, standIn, accessor));
}

function arrayIn(mesh, standIn, accessor) {
  check(mesh.origin.every((x) => x === 0), 'GLTF-7', 'a stream with an origin');
  if (standIn.kind === 'indices') {
    const indices = indicesOf(mesh, standIn.group);
    check(indices.length > 0, 'GLTF-11', 'a group without triangles');
    const Type = INDEX_ARRAYS[accessor.componentType];
    const largest = 2 ** (8 * (Type?.BYTES_PER_ELEMENT ?? 0)) - 1;
    const fits = fitsAccessor(accessor, 1, Type, indices) && indices.every((index) => index < largest);
    check(fits, 'GLTF-5', 'an accessor that does not fit the decoded indices');
    return Type === Uint32Array ? indices : Type.from(indices);
  }
  const attribute = mesh.attributes[standIn.number];
  check(standIn.kind === 'positions' || attribute, 'GLTF-4', "a number that none of the stream's attributes has");
  const [components, values] = standIn.kind === 'positions' ? [3, mesh.positions] : [attribute.components, attribute.values];
  check(
    fitsAccessor(accessor, components, values.constructor, values),
    'GLTF-5',
    `an accessor that does not fit the decoded ${standIn.kind === 'positions' ? 'positions' : attribute.name}`,
  );
  return values;
}
