// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors

/** The modules beside `core`. */
export type PartName = 'highpass' | 'zstd' | 'rare' | 'grid';

/**
 * A module in WebAssembly: a URL (absolute, or relative to the page), which is fetched, or read where it is a file's in node; its bytes;
 * a Response; a WebAssembly.Module; a promise of one of these; or a function that returns one, which is asked again where that failed.
 * These types need no more than `lib: es2022`.
 */
export type ModuleSource = string | object | (() => string | object);

/** A stream's bytes. */
export type StreamBytes = ArrayBuffer | ArrayBufferView | SharedArrayBuffer;

/** As AbortSignal. */
export interface SignalLike {
  readonly aborted: boolean;
  readonly reason: any;
  throwIfAborted(): void;
  addEventListener(type: 'abort', listener: () => void): void;
  removeEventListener(type: 'abort', listener: () => void): void;
}

/** As a browser's Worker. */
export interface WorkerLike {
  onmessage: ((event: any) => any) | null;
  onerror: ((event: any) => any) | null;
  postMessage(message: any, transfer: any[]): void;
  terminate(): void;
}

export interface DecoderOptions {
  /**
   * The modules; each is loaded when it is first needed, and compiled once for all decoders and workers of a page. Default: the files
   * beside this one, or where a bundler has not kept these, their texts, which are bundled. `core` decodes containers, faces,
   * predictive positions and most attributes, `highpass` the positions of highpass streams, `zstd` chunks that zstd coded
   * (the profile zstd; in others a chunk that is smaller so), `grid` maps from voxels, `rare` positions to the last bit, joints, weights, and
   * attributes of any kind that are coded as numbers (morph targets). All must be of one release.
   */
  files?: { [module in 'core' | PartName]?: ModuleSource };
  /** Whether the default files are those for machines with SIMD; default: as this machine has it. */
  simd?: boolean;
  /** Most bytes that the modules may take for their memory, which they share; default and at most 4 GiB. */
  maxMemory?: number;
}

/** What the caller is willing to receive. A stream beyond a limit is refused before anything of its size is allocated. */
export interface DecodeLimits {
  vertices?: number;
  triangles?: number;
  attributes?: number;
  attributeBytes?: number;
}

export type AttributeArray =
  | Int8Array<ArrayBuffer>
  | Uint8Array<ArrayBuffer>
  | Int16Array<ArrayBuffer>
  | Uint16Array<ArrayBuffer>
  | Int32Array<ArrayBuffer>
  | Uint32Array<ArrayBuffer>
  | Float32Array<ArrayBuffer>
  | Float64Array<ArrayBuffer>;

export interface AttributeInfo {
  /** As in the source: "nx", "TEXCOORD_0", "confidence". */
  name: string;
  kind: 'normal' | 'color' | 'uv' | 'generic' | 'tangent' | 'joints' | 'weights';
  components: number;
  /** Integers stand for [0, 1] or [-1, 1], as in glTF. */
  normalized: boolean;
  /** Colours: linear light, as glTF has them; else what a screen shows (sRGB). */
  linear: boolean;
  codedBytes: number;
  /**
   * Largest error that the encoder measured: of normals and tangents in degrees, of texture coordinates a distance, of colours in
   * 255ths of their range, of all others the difference of a component.
   */
  error: number;
}

export interface Attribute extends AttributeInfo {
  /** vertexCount x components. */
  values: AttributeArray;
}

export interface ChunkInfo {
  /** Four letters. */
  tag: string;
  codec: 'raw' | 'zstd' | 'compact';
  codedBytes: number;
  decodedBytes: number;
}

/** Errors that the encoder measured, model units. */
export interface Quality {
  /** Visual distortion error, root mean square. */
  vde: number;
  /** Low-frequency error, root mean square. */
  lfe: number;
  /** Largest distance of a vertex from its original. */
  maxError: number;
}

export interface StreamInfo {
  geometry: 'highpass' | 'predictive' | 'grid';
  /** The modules that its decoding needs beside `core`. */
  modules: PartName[];
  vertexCount: number;
  triangleCount: number;
  /** Vertices and faces are in the source's order. */
  keepsOrder: boolean;
  /** World position of a vertex = origin + its position. */
  origin: [number, number, number];
  /** Bounding box relative to the origin. */
  box: { min: [number, number, number]; max: [number, number, number] };
  quality: Quality;
  attributes: AttributeInfo[];
  chunks: ChunkInfo[];
}

export interface DecodedMesh extends StreamInfo {
  /** vertexCount x 3, relative to the origin. */
  positions: Float32Array<ArrayBuffer>;
  /** triangleCount x 3, each below vertexCount. */
  indices: Uint32Array<ArrayBuffer>;
  /** For each triangle the number of its group (material, primitive); null where there is one group. */
  groups: Uint32Array<ArrayBuffer> | null;
  attributes: Attribute[];
}

/** What is wrong, where, and which rule of the specification it breaks. Returned as a value; throw it if you like. */
export class DeltameshError extends Error {
  constructor(
    init: Pick<DeltameshError, 'code' | 'what'> & Partial<Pick<DeltameshError, 'rule' | 'where' | 'chunk' | 'source'>>,
    options?: { cause?: unknown },
  );
  /** 1xx: the stream is bad; 200: not a stream's bytes, or a bad option; 202: beyond a limit; 3xx: a module could not be loaded, or a glTF asset is bad; 900: out of memory; 901: a bug of ours. */
  code: number;
  what: string;
  /** Such as "DIR-4"; or empty. */
  rule: string;
  where: { unit: 'byte' | 'line' | 'vertex' | 'triangle' | 'attribute' | 'element' | 'accessor' | 'primitive'; position: number } | null;
  /** Tag of the chunk concerned, or empty. */
  chunk: string;
  /** The file, and in assets the mesh and primitive, where a loader knows them; or empty. */
  source: string;
}

export interface Decoder {
  /**
   * The mesh in `bytes`, in arrays of its own that may be transferred. Bytes are not trusted. Memory that a large mesh took is given
   * back afterwards. Does not throw.
   */
  decode(bytes: StreamBytes, options?: { limits?: DecodeLimits }): Promise<DecodedMesh | DeltameshError>;
  /** The same at once: the modules that inspect() tells must have been loaded; load() loads all. */
  decodeSync(bytes: StreamBytes, options?: { limits?: DecodeLimits }): DecodedMesh | DeltameshError;
  /** What the stream says of itself, without decoding it. */
  inspect(bytes: StreamBytes): StreamInfo | DeltameshError;
  /** Loads a module before it is needed, or all. Rejects where that fails. */
  load(module?: 'core' | PartName): Promise<void>;
  /** Gives back all memory; the decoder may be used again. */
  release(): void;
}

/** A decoder, once `core` is there. Rejects where that cannot be loaded. */
export function createDecoder(options?: DecoderOptions): Promise<Decoder>;

/** Whether this machine has WebAssembly's SIMD. */
export function supportsSimd(): boolean;
