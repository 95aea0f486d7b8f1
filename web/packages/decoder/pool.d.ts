// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
import type { DecodeLimits, DecodedMesh, DecoderOptions, DeltameshError, SignalLike, StreamBytes, WorkerLike } from './decoder.js';

export interface DecoderPoolOptions {
  /**
   * Most workers at a time, started when there is work for them; default 4. All pools of a page share their workers. 0: decodes on this
   * thread, as where there are no workers.
   */
  workers?: number;
  /** Modules are loaded on this thread, and sent to the workers. */
  decoder?: DecoderOptions;
  /**
   * For pages whose Content-Security-Policy allows no `worker-src blob:`: a module worker whose script is
   * `import '@deltamesh/decoder/worker.js'`. Pools share workers where they have the same function.
   */
  createWorker?: () => WorkerLike;
}

/** Decodes in workers, which are kept: a module is several times faster once it has run for a while. */
export class DecoderPool {
  constructor(options?: DecoderPoolOptions);
  /**
   * As Decoder.decode(), in the first worker that is free. `bytes` stay the caller's; the mesh's arrays are transferred. Rejects
   * with the signal's reason where that is aborted, and where no worker can be started. What failed is tried again by the next call.
   */
  decode(bytes: StreamBytes, options?: { limits?: DecodeLimits; signal?: SignalLike }): Promise<DecodedMesh | DeltameshError>;
  /** Starts a worker and loads the module `core` before they are needed. Rejects where that fails. */
  preload(): Promise<void>;
  /** What is not done is rejected; the workers end with the last pool. */
  dispose(): void;
}
