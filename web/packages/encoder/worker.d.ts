// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
import type { DeltameshError } from '@deltamesh/decoder';
import type { EncodeError, EncodeOptions, EncodedMesh, EncoderOptions, MeshComparison, MeshInput } from './encoder.js';

/** An encoder in a worker of its own, which is kept. Calls run one after the other. */
export class EncoderWorker {
  constructor(options?: {
    encoder?: EncoderOptions;
    /** For bundlers that do not follow `new Worker(new URL('./encode-worker.js', import.meta.url))`. */
    createWorker?: () => Worker;
  });
  /** As Encoder.encode(). The mesh is copied. Rejects with the signal's reason where that is aborted, which ends the work. */
  encode(mesh: MeshInput, options?: EncodeOptions & { signal?: AbortSignal }): Promise<EncodedMesh | EncodeError>;
  /** As Encoder.compare(). */
  compare(
    a: MeshInput,
    b: MeshInput,
    order?: Uint32Array,
    options?: { signal?: AbortSignal },
  ): Promise<MeshComparison | DeltameshError>;
  /** Ends the worker; what is not done, or asked for later, is rejected. */
  dispose(): void;
}
