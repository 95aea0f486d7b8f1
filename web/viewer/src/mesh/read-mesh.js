// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Files become meshes that the encoder takes, by the loaders of three.js. For workers.
import { DeltameshError, createDecoder } from '@deltamesh/decoder';
import { DeltameshLoader, gltfDeltameshExtension } from '@deltamesh/three';
import { MeshoptDecoder } from 'meshoptimizer/decoder';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { OBJLoader } from 'three/addons/loaders/OBJLoader.js';
import { PLYLoader } from 'three/addons/loaders/PLYLoader.js';
import { STLLoader } from 'three/addons/loaders/STLLoader.js';

import { joinMeshes, meshOfGeometry } from './from-geometry.js';

function readPly(buffer) {
  const geometry = new PLYLoader().parse(buffer);
  if (!geometry.index) throw new Error('this PLY file has no faces');
  return meshOfGeometry(geometry);
}

function readStl(buffer) {
  const geometry = new STLLoader().parse(buffer);
  geometry.deleteAttribute('normal'); // of faces, which their corners tell already
  return meshOfGeometry(geometry);
}

function meshesOf(object, options) {
  const meshes = [];
  object.updateMatrixWorld(true);
  object.traverse((child) => {
    if (!child.isMesh) return;
    meshes.push(meshOfGeometry(child.geometry.clone().applyMatrix4(child.matrixWorld), options));
  });
  if (meshes.length === 0) throw new Error('this file has no triangles');
  return joinMeshes(meshes);
}

function readObj(buffer) {
  const text = new TextDecoder().decode(buffer);
  const group = new OBJLoader().parse(text);
  // Without normals in the file the loader makes those of faces.
  if (!/^\s*vn\s/m.test(text)) group.traverse(({ geometry }) => geometry?.deleteAttribute('normal'));
  return meshesOf(group);
}

async function readGlb(buffer) {
  const deltamesh = new DeltameshLoader(undefined, { workers: 0 });
  const loader = new GLTFLoader().setMeshoptDecoder(MeshoptDecoder).register(gltfDeltameshExtension(deltamesh));
  const { scene } = await loader.parseAsync(buffer, '');
  deltamesh.dispose();
  return meshesOf(scene, { isLinear: true });
}

async function readDmsh(buffer, modules) {
  const decoder = await createDecoder({ files: modules });
  const mesh = await decoder.decode(new Uint8Array(buffer));
  if (mesh instanceof DeltameshError) throw mesh;
  return mesh;
}

const READERS = { ply: readPly, stl: readStl, obj: readObj, glb: readGlb, gltf: readGlb, dmsh: readDmsh };

export const FILE_TYPES = Object.keys(READERS);

/** `modules`: the decoder's. Throws what a person can read. */
export async function readMesh(name, buffer, modules) {
  const type = name.split('.').pop().toLowerCase();
  const read = READERS[type];
  if (!read) throw new Error(`${name} is none of ${FILE_TYPES.map((known) => known.toUpperCase()).join(', ')}`);
  const mesh = await read(buffer, modules);
  if (mesh.indices.length === 0) throw new Error(`${name} has no triangles`);
  return { origin: [0, 0, 0], ...mesh };
}
