// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// What users of the packages write: it has to compile.
import { registerDeltamesh } from '@deltamesh/babylon';
import { DeltameshError, createDecoder, supportsSimd } from '@deltamesh/decoder';
import { EXTENSION_NAME } from '@deltamesh/decoder/gltf';
import { openMap } from '@deltamesh/decoder/map';
import { createReceiver } from '@deltamesh/decoder/receiver';
import { DecoderPool } from '@deltamesh/decoder/pool';
import { createEncoder } from '@deltamesh/encoder';
import { EncoderWorker } from '@deltamesh/encoder/worker';
import { DeltameshMeshCompression } from '@deltamesh/gltf-transform';
import { DeltameshLoader, gltfDeltameshExtension } from '@deltamesh/three';
import { WebIO } from '@gltf-transform/core';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';

export async function decode(bytes: Uint8Array): Promise<Float32Array> {
  const decoder = await createDecoder({ simd: supportsSimd(), maxMemory: 2 ** 30 });
  await decoder.load('highpass');
  const info = decoder.inspect(bytes);
  if (info instanceof DeltameshError) throw info;
  const mesh = await decoder.decode(bytes, { limits: { vertices: 1000 } });
  if (mesh instanceof DeltameshError) throw new Error(`${mesh.code} ${mesh.rule} ${mesh.where?.position}`);
  const colors: number | undefined = mesh.attributes.find(({ kind }) => kind === 'color')?.values[0];
  return colors === undefined ? mesh.positions : Float32Array.of(colors, info.vertexCount, mesh.quality.vde);
}

export async function decodeInWorkers(bytes: Uint8Array, signal: AbortSignal): Promise<number> {
  const pool = new DecoderPool({ workers: 2, createWorker: () => new Worker('worker.js', { type: 'module' }) });
  const mesh = await pool.decode(bytes, { signal });
  pool.dispose();
  return mesh instanceof DeltameshError ? mesh.code : mesh.triangleCount;
}

export async function firstPart(manifest: Uint8Array, read: (file: string) => Uint8Array): Promise<Float32Array> {
  const map = await openMap(manifest);
  if (map instanceof DeltameshError) throw map;
  const mesh = map.decode(0, read(map.parts[0]!.file));
  return mesh instanceof DeltameshError ? new Float32Array() : mesh.positions;
}

export async function follow(socket: WebSocket): Promise<number> {
  const receiver = await createReceiver({ map: 7n });
  socket.onmessage = ({ data }) => receiver.apply(new Uint8Array(data));
  const messages = receiver.messages(performance.now() / 1000);
  if (messages instanceof DeltameshError) throw messages;
  for (const message of messages) socket.send(message);
  const change = receiver.takeChange();
  if (change instanceof DeltameshError) throw change;
  const meshes = change.changed.map((key) => receiver.find(key));
  return meshes.filter((mesh) => mesh !== null && !(mesh instanceof DeltameshError) && mesh.positions.length > 0).length;
}

export async function encode(positions: Float32Array, indices: Uint32Array): Promise<Uint8Array> {
  const encoder = await createEncoder();
  const packed = encoder.packGltf(new Uint8Array(), { maxError: 0.1, fallback: true });
  if (!(packed instanceof DeltameshError)) console.log(packed.bytes.length, packed.report.attributes[0].semantic);
  const encoded = encoder.encode(
    { positions, indices, attributes: [{ name: 'c', kind: 'color', components: 3, values: new Uint8Array(9) }] },
    { vde: { value: 0.02, unit: 'diagonal' }, geometry: 'auto', onProgress: (share: number) => console.log(share) },
  );
  if (encoded instanceof DeltameshError) throw new Error(`${encoded.message} ${encoded.best?.bytes}`);
  console.log(new Blob([encoded.bytes]), await WebAssembly.compile(encoded.bytes), await createDecoder({ files: { core: fetch('core.wasm') } }));
  return encoded.bytes;
}
export const compressInWorker = (mesh: Parameters<EncoderWorker['encode']>[0]) => new EncoderWorker().encode(mesh, { effort: 0 });

export async function load(url: string): Promise<void> {
  const loader = new DeltameshLoader().setLimits({ triangles: 1e6 }).preload();
  const geometry = await loader.loadAsync(url);
  const gltf = await new GLTFLoader().register(gltfDeltameshExtension(loader)).loadAsync(url);
  gltf.scene.add();
  geometry.dispose();
  loader.abort().dispose();
  registerDeltamesh({ pool: { workers: 1 } }).dispose();
}

export async function transform(bytes: Uint8Array): Promise<Uint8Array> {
  const io = new WebIO()
    .registerExtensions([DeltameshMeshCompression])
    .registerDependencies({ 'deltamesh.decoder': await createDecoder(), 'deltamesh.encoder': await createEncoder() });
  const document = await io.readBinary(bytes);
  document.createExtension(DeltameshMeshCompression).setEncoderOptions({ uvError: 0.001, fallback: true });
  return io.writeBinary(document);
}
export const name: 'DELTAMESH_mesh_compression' = EXTENSION_NAME;
