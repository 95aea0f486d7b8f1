// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// GLTFLoader with all that meshes may be compressed by.
import { DeltameshLoader, gltfDeltameshExtension } from '@deltamesh/three';
import { MeshoptDecoder } from 'meshoptimizer/decoder';
import { DRACOLoader } from 'three/addons/loaders/DRACOLoader.js';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';

/** `pool`: of the DeltameshLoader. Dispose of what comes with the loader when all is loaded. */
export function gltfLoader(manager, pool) {
  const deltamesh = new DeltameshLoader(undefined, pool);
  const draco = new DRACOLoader().setDecoderPath(new URL('./', import.meta.url).href).setWorkerLimit(1);
  const loader = new GLTFLoader(manager).setMeshoptDecoder(MeshoptDecoder).setDRACOLoader(draco).register(gltfDeltameshExtension(deltamesh));
  const dispose = () => {
    deltamesh.dispose();
    draco.dispose();
  };
  return { loader, dispose };
}
