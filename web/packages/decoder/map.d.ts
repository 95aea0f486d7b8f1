// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
import type { AttributeArray, DeltameshError, ModuleSource, Quality } from './decoder.js';

/** What the manifest (map.dmm) says of a part. */
export interface MapPartInfo {
  /** Its file, relative to the manifest. */
  file: string;
  /** 0: the smallest cells, and the most detail. */
  level: number;
  cell: [number, number, number];
  bytes: number;
  vertexCount: number;
  triangleCount: number;
  /** Of the decoded positions, relative to the map's origin. */
  box: { min: [number, number, number]; max: [number, number, number] };
  /** Against the part's source. */
  quality: Quality;
  /** Whether it is of those that together show all of the map, with the most detail. */
  isFinest: boolean;
}

export interface MapPartMesh {
  vertexCount: number;
  triangleCount: number;
  /** Of the map. */
  origin: [number, number, number];
  box: MapPartInfo['box'];
  quality: Quality;
  /** Relative to the origin. Those on borders are the same bits in every part. */
  positions: Float32Array;
  indices: Uint32Array;
  groups: Uint32Array | null;
  attributes: { name: string; kind: string; components: number; normalized: boolean; linear: boolean; values: AttributeArray }[];
}

export interface DeltameshMap {
  origin: [number, number, number];
  parts: MapPartInfo[];
  /** Decodes the part of that number from the bytes of its file. Does not throw. */
  decode(number: number, bytes: Uint8Array): MapPartMesh | DeltameshError;
  /** Gives back all memory; the map may be used again. */
  release(): void;
}

/** Reads a map's manifest. `file`: the module; default: the file beside this one. Rejects where that cannot be loaded. Needs SIMD. */
export function openMap(manifest: Uint8Array, options?: { file?: ModuleSource }): Promise<DeltameshMap | DeltameshError>;
