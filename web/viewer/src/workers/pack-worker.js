// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Packs the meshes of a GLB file; all else of it stays: materials, textures, animations, skins.
import { createDecoder } from '@deltamesh/decoder';
import { createEncoder } from '@deltamesh/encoder';
import { DeltameshMeshCompression } from '@deltamesh/gltf-transform';
import { WebIO } from '@gltf-transform/core';
import { ALL_EXTENSIONS, EXTMeshoptCompression, KHRDracoMeshCompression } from '@gltf-transform/extensions';
import createDraco from 'draco3d/draco_decoder_nodejs.js';
import { MeshoptDecoder } from 'meshoptimizer/decoder';

import { answerCalls, modules } from './answer.js';

/** Compression that the file had, which ours takes the place of. */
const OTHERS = [EXTMeshoptCompression.EXTENSION_NAME, KHRDracoMeshCompression.EXTENSION_NAME];

answerCalls({
  pack: async ({ file, options }) => {
    const [decoder, encoder] = await Promise.all([createDecoder({ files: modules }), createEncoder({ files: modules }), MeshoptDecoder.ready]);
    await decoder.load();
    const wasm = await fetch(new URL('./draco_decoder.wasm', import.meta.url));
    const draco = await createDraco({ wasmBinary: await wasm.arrayBuffer() });
    const io = new WebIO()
      .registerExtensions([...ALL_EXTENSIONS, DeltameshMeshCompression])
      .registerDependencies({ 'deltamesh.decoder': decoder, 'deltamesh.encoder': encoder, 'meshopt.decoder': MeshoptDecoder, 'draco3d.decoder': draco });
    const document = await io.readBinary(new Uint8Array(await file.arrayBuffer()));
    for (const extension of document.getRoot().listExtensionsUsed()) if (OTHERS.includes(extension.extensionName)) extension.dispose();
    document.createExtension(DeltameshMeshCompression).setRequired(true).setEncoderOptions(options);
    const glb = await io.writeBinary(document);
    return { result: glb, transfer: [glb.buffer] };
  },
});
