// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
import type { AttributeArray, DecodedMesh } from './decoder.js';

export const EXTENSION_NAME: 'DELTAMESH_mesh_compression';

/** What an accessor of a compressed primitive stands for. `source`: that primitive, as errors name it. */
export type StandIn = { bufferView: number; source: string } & (
  | { kind: 'positions' }
  | { kind: 'indices'; group: number }
  | { kind: 'attribute'; number: number }
);

/** Of all compressed primitives in a glTF document, by the accessors' numbers. Throws DeltameshError [GLTF-1 to 6]. */
export function findCompressed(json: object): Map<number, StandIn>;

/** The decoded data that an accessor stands for, in the accessor's component type. Throws DeltameshError [GLTF-4, 5, 7, 11]. */
export function arrayOf(
  mesh: DecodedMesh,
  standIn: StandIn,
  accessor: { type: string; componentType: number; count: number },
): AttributeArray;

/** The same error in `source`, which its message then begins with: a file, a primitive. What is no DeltameshError stays as it is. */
export function errorIn<Kind>(source: string, error: Kind): Kind;
