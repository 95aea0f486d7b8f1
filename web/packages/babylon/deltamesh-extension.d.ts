// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
import type { DecodeLimits } from '@deltamesh/decoder';
import type { DecoderPoolOptions } from '@deltamesh/decoder/pool';

/**
 * From now on Babylon.js's loader reads glTF assets with DELTAMESH_mesh_compression, in workers that are kept. A bad stream or asset
 * rejects with the DeltameshError's message.
 */
export function registerDeltamesh(options?: { pool?: DecoderPoolOptions; limits?: DecodeLimits }): {
  /** Ends the workers and takes the extension back. */
  dispose(): void;
};
