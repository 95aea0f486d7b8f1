// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
import type { GltfPackOptions } from '@deltamesh/encoder';
import { Extension, type PropertyType, type ReaderContext, type WriterContext } from '@gltf-transform/core';

/**
 * Reads and writes DELTAMESH_mesh_compression. Dependencies: 'deltamesh.decoder', a decoder whose modules are loaded (load()), and to write
 * 'deltamesh.encoder'. What cannot be read or encoded throws a DeltameshError.
 *
 * The whole document is packed when it is written, as Encoder.packGltf() of @deltamesh/encoder does it; its buffers become one.
 */
export class DeltameshMeshCompression extends Extension {
  static readonly EXTENSION_NAME: 'DELTAMESH_mesh_compression';
  readonly extensionName: 'DELTAMESH_mesh_compression';
  readonly prereadTypes: PropertyType[];
  readonly prewriteTypes: PropertyType[];
  readonly readDependencies: string[];
  readonly writeDependencies: string[];
  install(key: string, dependency: unknown): this;
  /** Those of Encoder.packGltf(). */
  setEncoderOptions(options: GltfPackOptions): this;
  preread(context: ReaderContext): this;
  read(context: ReaderContext): this;
  prewrite(context: WriterContext): this;
  write(context: WriterContext): this;
}
