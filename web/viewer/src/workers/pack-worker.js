// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Packs the meshes of a GLB file; all else of it stays: materials, textures, animations, skins.
import { DeltameshError } from '@deltamesh/decoder';
import { createEncoder } from '@deltamesh/encoder';
import { WebIO } from '@gltf-transform/core';
import { ALL_EXTENSIONS, EXTMeshoptCompression, KHRDracoMeshCompression } from '@gltf-transform/extensions';
import createDraco from 'draco3d/draco_decoder_nodejs.js';
import { MeshoptDecoder } from 'meshoptimizer/decoder';

import { answerCalls, modules } from './answer.js';

/** Compression that the file had, which ours takes the place of. */
const OTHERS = [EXTMeshoptCompression.EXTENSION_NAME, KHRDracoMeshCompression.EXTENSION_NAME];

function isCompressed(glb) {
  const size = new DataView(glb.buffer).getUint32(12, true);
  const { extensionsUsed = [] } = JSON.parse(new TextDecoder().decode(glb.subarray(20, 20 + size)));
  return extensionsUsed.some((name) => OTHERS.includes(name));
}

async function decompress(glb) {
  await MeshoptDecoder.ready;
  const wasm = await fetch(new URL('./draco_decoder.wasm', import.meta.url));
  const draco = await createDraco({ wasmBinary: await wasm.arrayBuffer() });
  const io = new WebIO().registerExtensions(ALL_EXTENSIONS).registerDependencies({ 'meshopt.decoder': MeshoptDecoder, 'draco3d.decoder': draco });
  const document = await io.readBinary(glb);
  for (const extension of document.getRoot().listExtensionsUsed()) if (OTHERS.includes(extension.extensionName)) extension.dispose();
  return io.writeBinary(document);
}

answerCalls({
  pack: async ({ file, options }) => {
    const encoder = await createEncoder({ files: modules });
    const glb = new Uint8Array(await file.arrayBuffer());
    const packed = encoder.packGltf(isCompressed(glb) ? await decompress(glb) : glb, options);
    if (packed instanceof DeltameshError) throw packed;
    return { result: packed.bytes, transfer: [packed.bytes.buffer] };
  },
});
