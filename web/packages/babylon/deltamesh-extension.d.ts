// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
import type { DecodeLimits } from '@deltamesh/decoder';
import type { DecoderPoolOptions } from '@deltamesh/decoder/pool';

/**
 * From now on Babylon.js reads glTF assets with DELTAMESH_mesh_compression, and .dmsh streams, in workers that are kept. A bad stream or
 * asset rejects with the DeltameshError's message, which names the file, or the mesh and the primitive.
 *
 * A stream becomes a mesh, its groups submeshes with their numbers as material indices, and `metadata.deltamesh` what is known of it:
 * { origin, quality, geometry, attributes, chunks }. Where the scene is left-handed the mesh is mirrored by its scaling, as glTF's are. Colours
 * are sRGB, as StandardMaterial takes them.
 */
export function registerDeltamesh(options?: { pool?: DecoderPoolOptions; limits?: DecodeLimits }): {
  /** Starts a worker and loads the first module before they are needed. Rejects where that fails. */
  preload(): Promise<void>;
  /** Ends the workers and takes the extension back; .dmsh streams are then refused. */
  dispose(): void;
};
