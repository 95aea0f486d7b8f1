// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
import type { EncodeOptions } from '@deltamesh/encoder';
import { Extension, type PropertyType, type ReaderContext, type WriterContext } from '@gltf-transform/core';

/**
 * Reads and writes DELTAMESH_mesh_compression. Dependencies: 'deltamesh.decoder', a decoder whose modules are loaded (load()), and to write
 * 'deltamesh.encoder'. What cannot be read or encoded throws a DeltameshError.
 *
 * Written is one stream for each mesh, of its primitives of triangles whose accessors nothing else uses; others stay as
 * they are, and meshes that would not get smaller. Meshes are compressed when the document is written, and come back in the coder's order.
 */
export class DeltameshMeshCompression extends Extension {
  static readonly EXTENSION_NAME: 'DELTAMESH_mesh_compression';
  readonly extensionName: 'DELTAMESH_mesh_compression';
  readonly prereadTypes: PropertyType[];
  readonly prewriteTypes: PropertyType[];
  readonly readDependencies: string[];
  readonly writeDependencies: string[];
  install(key: string, dependency: unknown): this;
  /** All options of the encoder. `attributeErrors` are by semantic; those of POSITION, NORMAL and TANGENT are for displacements of morph targets. */
  setEncoderOptions(options: Omit<EncodeOptions, 'onProgress'>): this;
  preread(context: ReaderContext): this;
  read(context: ReaderContext): this;
  prewrite(context: WriterContext): this;
  write(context: WriterContext): this;
}
