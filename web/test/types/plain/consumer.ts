// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// What needs no browser's types has to compile without them, the packages' own types too.
import { DeltameshError, createDecoder, type WorkerLike } from '@deltamesh/decoder';
import { findCompressed } from '@deltamesh/decoder/gltf';
import { openMap } from '@deltamesh/decoder/map';
import { DecoderPool } from '@deltamesh/decoder/pool';
import { createEncoder } from '@deltamesh/encoder';
import { EncoderWorker } from '@deltamesh/encoder/worker';

declare const worker: WorkerLike;

export async function decode(buffer: ArrayBuffer): Promise<Float32Array<ArrayBuffer>> {
  const decoder = await createDecoder({ files: { core: new Uint8Array(8), rare: async () => buffer, zstd: 'https://host/zstd.wasm' } });
  const pool = new DecoderPool({ createWorker: () => worker });
  await pool.preload();
  const mesh = await pool.decode(buffer);
  const same = decoder.decodeSync(new Uint8Array(buffer));
  if (mesh instanceof DeltameshError || same instanceof DeltameshError) throw mesh;
  const encoded = (await createEncoder()).encode(mesh);
  const compared = await new EncoderWorker().compare(mesh, same);
  if (encoded instanceof DeltameshError || compared instanceof DeltameshError) throw encoded;
  return mesh.positions;
}
export const open = (manifest: Uint8Array) => openMap(manifest, { file: () => manifest });
export const accessors = (json: object): number => findCompressed(json).size;
