// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Packs the meshes of a GLB file; all else of it stays: materials, textures, animations, skins.
import { createDecoder } from '@deltamesh/decoder';
import { createEncoder } from '@deltamesh/encoder';
import { DeltameshMeshCompression } from '@deltamesh/gltf-transform';
import { WebIO } from '@gltf-transform/core';
import { ALL_EXTENSIONS, EXTMeshoptCompression } from '@gltf-transform/extensions';
import { MeshoptDecoder } from 'meshoptimizer/decoder';

import { answerCalls, modules } from './answer.js';

answerCalls({
  pack: async ({ file, options }) => {
    const [decoder, encoder] = await Promise.all([createDecoder({ files: modules }), createEncoder({ files: modules }), MeshoptDecoder.ready]);
    await decoder.load();
    const io = new WebIO()
      .registerExtensions([...ALL_EXTENSIONS, DeltameshMeshCompression])
      .registerDependencies({ 'deltamesh.decoder': decoder, 'deltamesh.encoder': encoder, 'meshopt.decoder': MeshoptDecoder });
    const document = await io.readBinary(new Uint8Array(await file.arrayBuffer()));
    document.getRoot().listExtensionsUsed().find(({ extensionName }) => extensionName === EXTMeshoptCompression.EXTENSION_NAME)?.dispose();
    document.createExtension(DeltameshMeshCompression).setRequired(true).setEncoderOptions(options);
    const glb = await io.writeBinary(document);
    return { result: glb, transfer: [glb.buffer] };
  },
});
