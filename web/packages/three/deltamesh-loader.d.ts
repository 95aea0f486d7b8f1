// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
import type { AttributeInfo, ChunkInfo, DecodeLimits, DecodedMesh, Quality } from '@deltamesh/decoder';
import type { DecoderPool, DecoderPoolOptions } from '@deltamesh/decoder/pool';
import type { BufferGeometry, Loader, LoadingManager } from 'three';
import type { GLTFLoaderPlugin, GLTFParser } from 'three/addons/loaders/GLTFLoader.js';

/** `geometry.userData.deltamesh` */
export interface DeltameshUserData {
  /** World position = origin + position: give it to the object, or subtract that of another. */
  origin: [number, number, number];
  quality: Quality;
  geometry: 'highpass' | 'predictive' | 'grid';
  attributes: AttributeInfo[];
  chunks: ChunkInfo[];
}

/**
 * Attributes have the names that three.js gives them (normal, color, uv, uv1, tangent, skinIndex, skinWeight), generic ones their own.
 * Colours are linear: those of glTF (COLOR_0) as they are, those of other files converted from sRGB, as PLYLoader does it.
 * Groups of faces are groups with the material of their number. Takes the mesh's arrays.
 */
export function toBufferGeometry(mesh: DecodedMesh): BufferGeometry;

/** Loads .dmsh streams. All loaders of a page share their workers. Errors name the file, or the primitive of an asset. */
export class DeltameshLoader extends Loader<BufferGeometry> {
  constructor(manager?: LoadingManager, pool?: DecoderPoolOptions);
  readonly pool: DecoderPool;
  setLimits(limits: DecodeLimits): this;
  /** Starts a worker and loads the first module before they are needed. */
  preload(): this;
  /** Of all that is being loaded, assets too: they reject with an AbortError. */
  abort(): this;
  /** Rejects with a DeltameshError where the stream is bad, and with the signal's reason where that is aborted. */
  parseAsync(buffer: ArrayBuffer | ArrayBufferView, options?: { signal?: AbortSignal }): Promise<BufferGeometry>;
  /** What is not done is rejected; the workers end with the last loader. */
  dispose(): this;
}

/** For `gltfLoader.register(gltfDeltameshExtension(deltameshLoader))`. */
export function gltfDeltameshExtension(loader: DeltameshLoader): (parser: GLTFParser) => GLTFLoaderPlugin;
