// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
import type { DeltameshError, ModuleSource } from './decoder.js';
import type { MapPartMesh } from './map.js';

/** A cell of the map. */
export interface MapPartKey {
  level: number;
  cell: [number, number, number];
}

/** What is shown otherwise than at the last call. All of it fits together; half of it may have cracks. */
export interface MapChange {
  /** New, or with another mesh: see find(). */
  changed: MapPartKey[];
  removed: MapPartKey[];
  /** Parts that are announced and have not come. */
  lackingCount: number;
  /** Parts that the sender cannot send as they are asked for. */
  faultCount: number;
}

/**
 * The receiving side of a map that changes, whatever carries its messages (MapReceiver in C++). Calls do not throw. Where memory ends the
 * receiver begins anew by itself, with nothing. It has at most 65,536 parts, 128 MiB of them coded, and 16 million vertices.
 */
export interface MapReceiver {
  /** Applies a message of the sender; null: done, or of no effect. On an error nothing has changed. Decodes the part. */
  apply(message: Uint8Array): DeltameshError | null;
  /** What is to be sent to the sender now: call it after apply(), and 20 times a second. `now`: seconds of any steady clock. */
  messages(now: number): Uint8Array[] | DeltameshError;
  takeChange(): MapChange | DeltameshError;
  /** The part as it is shown; null where it is not. A copy. */
  find(key: MapPartKey): Omit<MapPartMesh, 'box' | 'quality'> | DeltameshError | null;
  /** Gives back all memory; the receiver begins anew when it is used again. */
  release(): void;
}

/** `map`: the map's id; `file`: the module; default: the file beside this one. Rejects where that cannot be loaded. Needs SIMD. */
export function createReceiver(options?: { map?: bigint | number; file?: ModuleSource }): Promise<MapReceiver>;
