// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// DELTAMESH_mesh_compression as an extension of glTF-Transform. See deltamesh-mesh-compression.d.ts.
import { DeltameshError } from '@deltamesh/decoder';
import { EXTENSION_NAME, arrayOf, findCompressed } from '@deltamesh/decoder/gltf';
import { Extension, PropertyType } from '@gltf-transform/core';

import { fromGlb, resourceOf, toGlb } from './glb.js';

const DECODER = 'deltamesh.decoder';
const ENCODER = 'deltamesh.encoder';

export class DeltameshMeshCompression extends Extension {
  static EXTENSION_NAME = EXTENSION_NAME;

  extensionName = EXTENSION_NAME;
  prereadTypes = [PropertyType.PRIMITIVE];
  prewriteTypes = [PropertyType.ACCESSOR];
  readDependencies = [DECODER];
  writeDependencies = [ENCODER];

  #dependencies = {};
  #options = {};

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
    const { json } = context.jsonDoc;
    const decoder = this.#dependency(DECODER);
    const meshes = new Map();
    for (const [number, standIn] of findCompressed(json)) {
      const { bufferView } = standIn;
      if (!meshes.has(bufferView)) meshes.set(bufferView, decode(decoder, bytesOf(context.jsonDoc, bufferView)));
      context.accessors[number].setArray(arrayOf(meshes.get(bufferView), standIn, json.accessors[number]).slice());
    }
    return this;
  }

  read() {
    return this;
  }

  prewrite(context) {
    afterWriting(this.document, context, () => {
      const packed = this.#dependency(ENCODER).packGltf(toGlb(context.jsonDoc, EXTENSION_NAME), this.#options);
      if (packed instanceof DeltameshError) throw packed;
      fromGlb(context.jsonDoc, packed.bytes);
    });
    return this;
  }

  write() {
    return this;
  }
}

/** glTF-Transform writes extensions by name, and packing takes the whole document: `work` is done when the last of them is written. */
function afterWriting(document, context, work) {
  const registered = new Set(context.options.extensions.map((extension) => extension.EXTENSION_NAME));
  const last = document
    .getRoot()
    .listExtensionsUsed()
    .filter(({ extensionName }) => registered.has(extensionName))
    .reduce((a, b) => (a.extensionName > b.extensionName ? a : b));
  last.write = (given) => {
    delete last.write; // the class has its own
    last.write(given);
    if (given === context) work();
    return last;
  };
}

function decode(decoder, bytes) {
  const mesh = decoder.decodeSync(bytes);
  if (mesh instanceof DeltameshError) throw mesh;
  return mesh;
}

function bytesOf(document, bufferView) {
  const { buffer, byteOffset = 0, byteLength } = document.json.bufferViews[bufferView];
  return resourceOf(document, buffer).subarray(byteOffset, byteOffset + byteLength);
}
