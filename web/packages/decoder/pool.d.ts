// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
import type { DecodeLimits, DecodedMesh, DecoderOptions, DeltameshError } from './decoder.js';

export interface DecoderPoolOptions {
  /** Most workers, started when there is work for them; default 4. 0: decodes on this thread, as where there are no workers. */
  workers?: number;
  /** Of each worker's decoder; must be such that workers can be sent it. */
  decoder?: DecoderOptions;
  /** For bundlers that do not follow `new Worker(new URL('./worker.js', import.meta.url))`. */
  createWorker?: () => Worker;
}

/** Decodes in workers, which are kept: a module is several times faster once it has run for a while. */
export class DecoderPool {
  constructor(options?: DecoderPoolOptions);
  /**
   * As Decoder.decode(), in the first worker that is free. `bytes` stay the caller's; the mesh's arrays are transferred. Rejects
   * with the signal's reason where that is aborted, and where no decoder can be started.
   */
  decode(bytes: Uint8Array, options?: { limits?: DecodeLimits; signal?: AbortSignal }): Promise<DecodedMesh | DeltameshError>;
  /** Ends the workers; what is not done is rejected. */
  dispose(): void;
}
