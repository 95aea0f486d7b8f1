// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// DELTAMESH_mesh_compression as an extension of glTF-Transform. See deltamesh-mesh-compression.d.ts.
import { DeltameshError } from '@deltamesh/decoder';
import { EXTENSION_NAME, arrayOf, findCompressed } from '@deltamesh/decoder/gltf';
import { Extension, PropertyType } from '@gltf-transform/core';

import { packMeshes } from './pack.js';

const DECODER = 'deltamesh.decoder';
const ENCODER = 'deltamesh.encoder';
const GLB_BUFFER = '@glb.bin';

export class DeltameshMeshCompression extends Extension {
  static EXTENSION_NAME = EXTENSION_NAME;

  extensionName = EXTENSION_NAME;
  prereadTypes = [PropertyType.PRIMITIVE];
  prewriteTypes = [PropertyType.ACCESSOR];
  readDependencies = [DECODER];
  writeDependencies = [ENCODER, DECODER];

  #dependencies = {};
  #options = {};
  #packed = new Map();

  install(key, dependency) {
    this.#dependencies[key] = dependency;
    return this;
  }

  setEncoderOptions(options) {
    this.#options = options;
    return this;
  }

  #dependency(key) {
    const dependency = this.#dependencies[key];
    if (!dependency) throw new Error(`[${EXTENSION_NAME}] Please install extension dependency, "${key}".`);
    return dependency;
  }

  preread(context) {
    const { json, resources } = context.jsonDoc;
    const decoder = this.#dependency(DECODER);
    const meshes = new Map();
    for (const [number, standIn] of findCompressed(json)) {
      const { bufferView } = standIn;
      if (!meshes.has(bufferView)) meshes.set(bufferView, decode(decoder, bytesOf(json, resources, bufferView)));
      context.accessors[number].setArray(arrayOf(meshes.get(bufferView), standIn, json.accessors[number]).slice());
    }
    return this;
  }

  read() {
    return this;
  }

  prewrite(context) {
    this.#packed = packMeshes(this.document, context, this.#options, (mesh, options) => {
      const encoded = this.#dependency(ENCODER).encode(mesh, options);
      if (encoded instanceof DeltameshError) throw encoded;
      const decoded = decode(this.#dependency(DECODER), encoded.bytes);
      return { bytes: encoded.bytes, decoded, maxError: decoded.quality.maxError };
    });
    return this;
  }

  write(context) {
    const { json } = context.jsonDoc;
    for (const mesh of this.document.getRoot().listMeshes()) {
      const { primitives } = json.meshes[context.meshIndexMap.get(mesh)];
      for (const [i, primitive] of mesh.listPrimitives().entries()) {
        const packed = this.#packed.get(primitive);
        if (!packed) continue;
        const { bytes, accessors, extension } = packed;
        const { targets = [], ...own } = accessors;
        Object.assign(primitives[i], own);
        targets.forEach((target, t) => Object.assign(primitives[i].targets[t], target));
        const bufferView = context.otherBufferViewsIndexMap.get(bytes);
        primitives[i].extensions = { ...primitives[i].extensions, [EXTENSION_NAME]: { bufferView, ...extension } };
      }
    }
    if (this.#packed.size === 0) {
      for (const list of ['extensionsUsed', 'extensionsRequired'])
        if (json[list]) json[list] = json[list].filter((name) => name !== EXTENSION_NAME);
    }
    return this;
  }
}

function decode(decoder, bytes) {
  const mesh = decoder.decodeSync(bytes);
  if (mesh instanceof DeltameshError) throw mesh;
  return mesh;
}

function bytesOf(json, resources, bufferView) {
  const { buffer, byteOffset = 0, byteLength } = json.bufferViews[bufferView];
  const resource = resources[json.buffers[buffer].uri ?? GLB_BUFFER];
  return resource.subarray(byteOffset, byteOffset + byteLength);
}
