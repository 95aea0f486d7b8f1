// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// .dmsh streams and glTF assets with DELTAMESH_mesh_compression in three.js. See deltamesh-loader.d.ts.
import { DeltameshError } from '@deltamesh/decoder';
import { EXTENSION_NAME, arrayOf, errorIn, findCompressed } from '@deltamesh/decoder/gltf';
import { DecoderPool } from '@deltamesh/decoder/pool';
import { BufferAttribute, BufferGeometry, FileLoader, Loader } from 'three';

import { linearFromSrgb } from './colors.js';

const NAMES = { normal: 'normal', color: 'color', tangent: 'tangent', joints: 'skinIndex', weights: 'skinWeight' };

/** What three.js calls an attribute; `numbers`: of each kind so far. */
function nameOf({ kind, name }, numbers) {
  if (kind === 'generic') return name;
  const number = (numbers[kind] = (numbers[kind] ?? -1) + 1);
  if (kind === 'uv') return number === 0 ? 'uv' : `uv${number}`;
  return number === 0 ? NAMES[kind] : name;
}

/** Sorts triangles by group; every group becomes a range with the material of its number. */
function addGroups(geometry, { indices, groups }) {
  const counts = new Uint32Array(groups.reduce((most, group) => Math.max(most, group), 0) + 1);
  for (const group of groups) ++counts[group];
  const next = new Uint32Array(counts.length);
  for (let group = 1; group < counts.length; ++group) next[group] = next[group - 1] + counts[group - 1];
  counts.forEach((count, group) => {
    if (count > 0) geometry.addGroup(3 * next[group], 3 * count, group);
  });
  const sorted = new Uint32Array(indices.length);
  groups.forEach((group, face) => sorted.set(indices.subarray(3 * face, 3 * face + 3), 3 * next[group]++));
  return sorted;
}

export function toBufferGeometry(mesh) {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(mesh.positions, 3));
  const numbers = {};
  for (const attribute of mesh.attributes) {
    const { components, normalized, kind } = attribute;
    const isColor = kind === 'color';
    const values = isColor && !attribute.linear ? linearFromSrgb(attribute) : attribute.values;
    const isPart = normalized || (isColor && !(values instanceof Float32Array));
    geometry.setAttribute(nameOf(attribute, numbers), new BufferAttribute(values, components, isPart));
  }
  geometry.setIndex(new BufferAttribute(mesh.groups ? addGroups(geometry, mesh) : mesh.indices, 1));
  const { origin, quality, chunks, geometry: coder } = mesh;
  const attributes = mesh.attributes.map(({ values, ...info }) => info);
  geometry.userData.deltamesh = { origin, quality, geometry: coder, attributes, chunks };
  return geometry;
}

export class DeltameshLoader extends Loader {
  #abort = new AbortController();

  /** `pool`: DecoderPoolOptions. */
  constructor(manager, pool) {
    super(manager);
    this.limits = undefined;
    this.pool = new DecoderPool(pool);
  }

  setLimits(limits) {
    this.limits = limits;
    return this;
  }

  /** Starts a worker and loads the first module before they are needed; where that fails the next load tries again. */
  preload() {
    this.pool.preload().catch(() => {});
    return this;
  }

  /** Aborted by abort(). */
  get signal() {
    return this.#abort.signal;
  }

  /** Of all that is being loaded, assets of the plugin too. */
  abort() {
    this.#abort.abort();
    this.#abort = new AbortController();
    return this;
  }

  load(url, onLoad, onProgress, onError = console.error) {
    const { signal } = this;
    const loader = new FileLoader(this.manager);
    loader.setPath(this.path);
    loader.setResponseType('arraybuffer');
    loader.setRequestHeader(this.requestHeader);
    loader.setWithCredentials(this.withCredentials);
    const abort = () => loader.abort?.(); // three.js has it since r179
    signal.addEventListener('abort', abort, { once: true });
    const decode = async (buffer) => {
      this.manager.itemStart(url); // the manager waits for the geometry, not only for the file
      try {
        onLoad(await this.parseAsync(buffer, { signal }).catch((error) => Promise.reject(errorIn(url, error))));
      } catch (error) {
        this.manager.itemError(url);
        onError(error);
      } finally {
        signal.removeEventListener('abort', abort);
        this.manager.itemEnd(url);
      }
    };
    loader.load(url, decode, onProgress, onError);
  }

  /** Rejects with a DeltameshError, or with the signal's reason. */
  async parseAsync(buffer, { signal = this.signal } = {}) {
    const mesh = await this.pool.decode(buffer, { limits: this.limits, signal });
    if (mesh instanceof DeltameshError) throw mesh;
    return toBufferGeometry(mesh);
  }

  dispose() {
    this.pool.dispose();
    return this;
  }
}

/** GLTFLoader has no hook for primitives: accessors are given views of their own, whose bytes are decoded when they are asked for. */
class GltfDeltameshExtension {
  #views = new Map();
  #meshes = new Map();

  constructor(parser, loader) {
    this.name = EXTENSION_NAME;
    this.parser = parser;
    this.loader = loader;
  }

  async beforeRoot() {
    const { json } = this.parser;
    for (const [number, standIn] of findCompressed(json)) {
      const accessor = json.accessors[number];
      delete accessor.sparse;
      accessor.byteOffset = 0;
      accessor.bufferView = json.bufferViews.length;
      this.#views.set(accessor.bufferView, { standIn, accessor });
      json.bufferViews.push({ buffer: 0, byteLength: 0 });
    }
  }

  loadBufferView(number) {
    const view = this.#views.get(number);
    return view ? this.#decode(view) : null;
  }

  async #decode({ standIn, accessor }) {
    const { bufferView, source } = standIn;
    if (!this.#meshes.has(bufferView)) this.#meshes.set(bufferView, this.#decodeStream(bufferView, source));
    const values = arrayOf(await this.#meshes.get(bufferView), standIn, accessor);
    return values.buffer.byteLength === values.byteLength ? values.buffer : values.slice().buffer;
  }

  async #decodeStream(bufferView, source) {
    const { pool, limits, signal } = this.loader;
    const mesh = await pool.decode(await this.parser.getDependency('bufferView', bufferView), { limits, signal });
    if (mesh instanceof DeltameshError) throw errorIn(source, mesh);
    return mesh;
  }
}

export function gltfDeltameshExtension(loader) {
  return (parser) => new GltfDeltameshExtension(parser, loader);
}
