// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
import type { DeltameshError, SignalLike, WorkerLike } from '@deltamesh/decoder';
import type { EncodeError, EncodeOptions, EncodedMesh, EncoderOptions, GltfPackOptions, MeshComparison, MeshInput, PackedGltf } from './encoder.js';

/** An encoder in a worker of its own, in browsers and in node, which is kept. Calls run one after the other. */
export class EncoderWorker {
  constructor(options?: {
    encoder?: EncoderOptions;
    /** For pages that allow no `worker-src blob:`: a module worker whose script is `import '@deltamesh/encoder/encode-worker.js'`. */
    createWorker?: () => WorkerLike;
  });
  /** Loads the module and starts the worker before they are needed. */
  preload(): Promise<void>;
  /** As Encoder.encode(). The mesh is copied. Rejects with the signal's reason where that is aborted, which ends the work. */
  encode(mesh: MeshInput, options?: EncodeOptions & { signal?: SignalLike }): Promise<EncodedMesh | EncodeError>;
  /** As Encoder.packGltf(). The asset is copied. */
  packGltf(asset: Uint8Array, options?: GltfPackOptions & { signal?: SignalLike }): Promise<PackedGltf | DeltameshError>;
  /** As Encoder.compare(). */
  compare(
    a: MeshInput,
    b: MeshInput,
    order?: Uint32Array,
    options?: { signal?: SignalLike },
  ): Promise<MeshComparison | DeltameshError>;
  /** Ends the worker; what is not done, or asked for later, is rejected. */
  dispose(): void;
}
