// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
import type { AttributeInfo, DeltameshError, ModuleSource, Quality } from '@deltamesh/decoder';

export interface EncoderOptions {
  /** The module; default: the file beside this one. */
  files?: { encoder?: ModuleSource };
  /** Most bytes that the module may take for its memory; default 4 GiB. */
  maxMemory?: number;
}

export interface MeshInput {
  /** n x 3, relative to the origin. */
  positions: Float32Array;
  /** m x 3, each below n. */
  indices: Uint32Array;
  /** Default 0, 0, 0. */
  origin?: ArrayLike<number>;
  /** m: number of the group (material, primitive) of every triangle, below 2^16. */
  groups?: ArrayLike<number> | null;
  attributes?: {
    name: string;
    kind: AttributeInfo['kind'];
    /** 1 to 16 */
    components: number;
    /** Integers stand for [0, 1] or [-1, 1]; default false. */
    normalized?: boolean;
    /** Colours: linear light, as glTF has them; else what a screen shows (sRGB). */
    linear?: boolean;
    /** n x components */
    values: Int8Array | Uint8Array | Int16Array | Uint16Array | Int32Array | Uint32Array | Float32Array | Float64Array;
  }[];
}

/** An upper bound: a number in model units, or in percent of the bounding box' diagonal, or as the paper's sum. */
export type Bound = number | { value: number; unit: 'model' | 'diagonal' | 'paper' };

/** As the program's options; without any the result looks the same as the source. */
export interface EncodeOptions {
  /** Visual distortion error, low-frequency error (root mean squares), largest error of a vertex. May be combined. */
  vde?: Bound;
  lfe?: Bound;
  maxError?: Bound;
  /** The whole stream has no more bytes. Where any bound of attributes is given, all hold, the defaults too; without any, all errors grow together. */
  targetBytes?: number;
  geometry?: 'auto' | 'highpass' | 'predictive';
  lossless?: boolean;
  /** 0 (few passes), 1 or 2; default 1. */
  effort?: number;
  /** By hand, in place of a quality. */
  bits?: number;
  step?: number;
  anchors?: number;
  anchorDensity?: number;
  anchorBits?: number;
  /** Degrees; default 0.5. */
  normalError?: number;
  /** Degrees; default: as normals. */
  tangentError?: number;
  /** Distance; default 1/4096. */
  uvError?: number;
  /** Largest difference of a component, 255ths of its range; 0 is exact. Without it and colorRms photographs are kept to 41 dB, labels exactly. */
  colorError?: number;
  /** In place of it: root mean square of the errors of red, green and blue, 255ths; 2.27 is 41 dB. */
  colorRms?: number;
  /** Default 1/1024. */
  weightError?: number;
  /** Of generic attributes by their names, in their units; others are exact. */
  attributeErrors?: Record<string, number>;
  /** In place of it, of generic attributes of one component: root mean square of their errors. */
  attributeRms?: Record<string, number>;
  profile?: 'smallest' | 'zstd';
  /** Restores the input's order of vertices and faces. */
  keepOrder?: boolean;
  /** Keeps vertices that no face uses. */
  keepUnreferenced?: boolean;
  /** Called now and then with the share of the work done, 0 to 1. */
  onProgress?: (share: number) => void;
}

export interface EncodedMesh {
  /** The .dmsh stream; `inspect()` of @deltamesh/decoder tells its quality and parts. */
  bytes: Uint8Array<ArrayBuffer>;
  /** Input vertex of every decoded vertex. */
  order: Uint32Array<ArrayBuffer>;
}

export interface GltfPackOptions extends EncodeOptions {
  /** Keeps plain accessors, holding what the streams decode to, beside the streams: for readers without the extension. */
  fallback?: boolean;
}

/** What was done, in primitives, vertices and bytes, as `deltamesh gltf pack` tells it. */
export interface GltfReport {
  primitives: number;
  /** Of them are compressed. */
  converted: number;
  /** Primitives of one mesh share one. */
  streams: number;
  /** Left as they are: what has no triangles, positions of types that glTF does not have, what is compressed already, what would grow. */
  notTriangles: number;
  notFloatPositions: number;
  otherwiseCompressed: number;
  notSmaller: number;
  /** In the streams. */
  vertices: number;
  triangles: number;
  /** Dropped: no face used them, they drew nothing, another vertex was equal; and lengths of normals and tangents. */
  unreferencedVertices: number;
  degenerateTriangles: number;
  weldedVertices: number;
  droppedLengths: number;
  streamBytes: number;
  inputBytes: number;
  outputBytes: number;
  animationBytes: number;
  imageBytes: number;
  /** Largest distance of a vertex from its original, in model units of its mesh and in percent of that one's diagonal. */
  maxError: number;
  maxErrorPercent: number;
  attributes: { semantic: string; morph: boolean; kind: AttributeInfo['kind']; bytes: number; error: number }[];
}

export interface PackedGltf {
  /** A GLB. */
  bytes: Uint8Array<ArrayBuffer>;
  report: GltfReport;
}

/** Where a request cannot be met the error says what can be had. */
export type EncodeError = DeltameshError & { best?: { value: number; bytes: number } };

export interface MeshComparison {
  /** Vertices and faces correspond, so that `quality` is there. */
  corresponding: boolean;
  quality: Quality;
  /** Symmetric distance between the surfaces, model units. */
  surfaceRms: number;
  surfaceMax: number;
  /** Degrees, between vertex normals. */
  normalAngleMean: number;
  normalAngleP95: number;
  /** Of the first mesh's bounding box. */
  diagonal: number;
  /** Per vertex of the second mesh: how far it is from the first along its normal, outward positive. */
  signedError: Float32Array<ArrayBuffer>;
}

export interface Encoder {
  /** The same mesh and options give the same bytes, those of the native encoder. Takes long: call it in a worker. Does not throw. */
  encode(mesh: MeshInput, options?: EncodeOptions): EncodedMesh | EncodeError;
  /**
   * Compresses the meshes of an asset: a GLB, or the JSON of a .gltf with its buffers in it. Bounds of `attributeErrors` are by semantic;
   * those of POSITION, NORMAL and TANGENT hold for morph targets. The result has the bytes of `deltamesh gltf pack`. Takes long. Does not throw.
   */
  packGltf(asset: Uint8Array, options?: GltfPackOptions): PackedGltf | DeltameshError;
  /**
   * How far `b` is from `a`. `order`: the vertex of `a` for every vertex of `b`, as encode() gives it; without it they correspond by
   * number, or are matched.
   */
  compare(a: MeshInput, b: MeshInput, order?: Uint32Array): MeshComparison | DeltameshError;
  /** Gives back all memory; the encoder may be used again. */
  release(): void;
}

/** Rejects where the module cannot be loaded. */
export function createEncoder(options?: EncoderOptions): Promise<Encoder>;
