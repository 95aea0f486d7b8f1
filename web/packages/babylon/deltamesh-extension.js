// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// DELTAMESH_mesh_compression in Babylon.js's loader of glTF. See deltamesh-extension.d.ts.
import {
  registerGLTFExtension,
  unregisterGLTFExtension,
} from '@babylonjs/loaders/glTF/2.0/glTFLoaderExtensionRegistry.js';
import { DeltameshError } from '@deltamesh/decoder';
import { EXTENSION_NAME, arrayOf, errorIn, findCompressed } from '@deltamesh/decoder/gltf';
import { DecoderPool } from '@deltamesh/decoder/pool';

import { registerStreamLoader } from './stream-loader.js';

/** Accessors are given views of their own, whose bytes are decoded when they are asked for: that serves morph targets, too. */
class DeltameshExtension {
  name = EXTENSION_NAME;
  order = 100;
  #views = new Map();
  #meshes = new Map();

  constructor(loader, pool, limits) {
    this.loader = loader;
    this.pool = pool;
    this.limits = limits;
    this.enabled = loader.isExtensionUsed(EXTENSION_NAME);
  }

  dispose() {
    this.loader = null;
  }

  onLoading() {
    const { gltf } = this.loader;
    for (const [number, standIn] of findCompressed(gltf)) {
      const accessor = gltf.accessors[number];
      delete accessor.sparse;
      accessor.byteOffset = 0;
      accessor.bufferView = gltf.bufferViews.length;
      const view = { index: accessor.bufferView, buffer: 0, byteLength: 0 };
      gltf.bufferViews.push(view);
      this.#views.set(view, { standIn, accessor });
    }
  }

  loadBufferViewAsync(context, bufferView) {
    const view = this.#views.get(bufferView);
    return view ? this.#decode(view) : null;
  }

  async #decode({ standIn, accessor }) {
    const { bufferView, source } = standIn;
    if (!this.#meshes.has(bufferView)) this.#meshes.set(bufferView, this.#decodeStream(bufferView, source));
    const values = arrayOf(await this.#meshes.get(bufferView), standIn, accessor);
    return new Uint8Array(values.buffer, values.byteOffset, values.byteLength);
  }

  async #decodeStream(bufferView, source) {
    const { buffer, byteOffset = 0, byteLength } = this.loader.gltf.bufferViews[bufferView];
    const data = await this.loader.loadBufferViewAsync(`/bufferViews/${bufferView}`, {
      index: bufferView,
      buffer,
      byteOffset,
      byteLength,
    });
    const mesh = await this.pool.decode(data, { limits: this.limits });
    if (mesh instanceof DeltameshError) throw errorIn(source, mesh);
    return mesh;
  }
}

export function registerDeltamesh({ pool, limits } = {}) {
  const decoders = new DecoderPool(pool);
  registerGLTFExtension(EXTENSION_NAME, true, (loader) => new DeltameshExtension(loader, decoders, limits));
  registerStreamLoader((bytes) => decoders.decode(bytes, { limits }));
  return {
    preload: () => decoders.preload(),
    dispose() {
      unregisterGLTFExtension(EXTENSION_NAME);
      decoders.dispose();
    },
  };
}
