// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Files become meshes that the encoder takes, by the loaders of three.js. For workers.
import { DeltameshError, createDecoder } from '@deltamesh/decoder';
import { BufferAttribute, LoadingManager } from 'three';
import { OBJLoader } from 'three/addons/loaders/OBJLoader.js';
import { PLYLoader } from 'three/addons/loaders/PLYLoader.js';
import { STLLoader } from 'three/addons/loaders/STLLoader.js';

import { floatsOf, meshOfGeometry } from './from-geometry.js';
import { gltfLoader } from './gltf-loader.js';
import { joinMeshes } from './join.js';
import { MESH_SUFFIXES, suffixOf } from './mesh-names.js';
import { withOtherFiles } from './other-files.js';

/** Bytes of a PLY file among which its header's end must be. */
const MOST_HEADER = 2 ** 16;

function readPly(buffer) {
  const header = new TextDecoder('latin1').decode(buffer.slice(0, MOST_HEADER));
  if (!header.includes('end_header')) throw new Error('its header has no end');
  const geometry = new PLYLoader().parse(buffer);
  if (!geometry.index) throw new Error('it has no faces');
  return meshOfGeometry(geometry);
}

function readStl(buffer) {
  const geometry = new STLLoader().parse(buffer);
  geometry.deleteAttribute('normal'); // of faces, which their corners tell already
  return meshOfGeometry(geometry);
}

/** In the world's coordinates, which whole numbers would not hold. */
function inWorld({ geometry, matrixWorld }) {
  const moved = geometry.clone();
  moved.morphAttributes = {};
  for (const name of ['position', 'normal', 'tangent']) {
    const attribute = moved.attributes[name];
    if (attribute) moved.setAttribute(name, new BufferAttribute(floatsOf(attribute, attribute.itemSize), attribute.itemSize));
  }
  return moved.applyMatrix4(matrixWorld);
}

/** One mesh; `places`, for each mesh of three.js: { start, corners }, its first vertex there and, where it has no index, numbers of its vertices. */
function meshesOf(object, options) {
  const meshes = [];
  const places = [];
  let start = 0;
  object.updateMatrixWorld(true);
  object.traverse((child) => {
    if (!child.isMesh) return;
    const { corners = null, ...mesh } = meshOfGeometry(inWorld(child), options);
    places.push({ start, corners });
    start += mesh.positions.length / 3;
    meshes.push(mesh);
  });
  if (meshes.length === 0) throw new Error('it has no triangles');
  return { mesh: joinMeshes(meshes), places };
}

function readObj(buffer) {
  const text = new TextDecoder().decode(buffer);
  const group = new OBJLoader().parse(text);
  // Without normals in the file the loader makes those of faces.
  if (!/^\s*vn\s/m.test(text)) group.traverse(({ geometry }) => geometry?.deleteAttribute('normal'));
  return { ...meshesOf(group).mesh, up: 'y' };
}

/** The page reads materials with their textures itself. */
const withoutTextures = () => ({ name: 'without textures', loadTexture: async () => null });

/** Nothing is fetched: what a file names must be within it. */
function withinFile(url) {
  if (!/^(data|blob):/.test(url)) throw new Error(`it needs ${url}, which is not a part of it`);
  return url;
}

async function readGltf(buffer, { others, modules }) {
  const manager = new LoadingManager().setURLModifier(withinFile);
  const { loader, dispose } = gltfLoader(manager, { workers: 0, files: modules });
  try {
    const { scene } = await loader.register(withoutTextures).parseAsync(withOtherFiles(buffer, others), '');
    const { mesh, places } = meshesOf(scene, { isLinear: true });
    return { ...mesh, up: 'y', places };
  } finally {
    dispose();
  }
}

async function readDmsh(buffer, { modules }) {
  const decoder = await createDecoder({ files: modules });
  const mesh = await decoder.decode(new Uint8Array(buffer));
  if (mesh instanceof DeltameshError) throw mesh;
  const isFromGltf = mesh.attributes.some(({ name }) => /^(NORMAL|TANGENT|(TEXCOORD|COLOR)_\d+)$/.test(name));
  return { ...mesh, up: isFromGltf ? 'y' : 'z' };
}

const READERS = { __proto__: null, ply: readPly, stl: readStl, obj: readObj, glb: readGltf, gltf: readGltf, dmsh: readDmsh };
/** First letters of files that may have any name. */
const MAGICS = { glTF: 'glb', DMSH: 'dmsh', 'ply\n': 'ply', 'ply\r': 'ply' };

const magicOf = (buffer) => new TextDecoder('latin1').decode(buffer.slice(0, 4));
const typeOf = (name, buffer) => MAGICS[magicOf(buffer)] ?? suffixOf(name);

/** Throws where a mesh is none that can be drawn and encoded. */
function check({ positions, indices }) {
  if (indices.length === 0) throw new Error('it has no triangles');
  const count = positions.length / 3;
  if (indices.some((index) => index >= count)) throw new Error(`a face has a vertex that is none of its ${count}`);
  if (!positions.every(Number.isFinite)) throw new Error('a coordinate is not a finite number');
}

/**
 * `others`: files that a .gltf may need. `modules`: the decoder's. With the mesh come `up`, the axis, and of glTF `places`, see meshesOf(), and
 * `isGlb`. Throws what a person can read.
 */
export async function readMesh(file, { others = [], modules }) {
  const { name, size } = file;
  if (size === 0) throw new Error(`${name} is empty`);
  const buffer = await file.arrayBuffer();
  const type = typeOf(name, buffer);
  if (!READERS[type]) throw new Error(`${name} is none of ${MESH_SUFFIXES.join(', ').toUpperCase()}`);
  try {
    const { up = 'z', places = null, corners, ...mesh } = await READERS[type](buffer, { others, modules });
    check(mesh);
    return { mesh: { origin: [0, 0, 0], ...mesh }, up, places, isGlb: type === 'glb' && magicOf(buffer) === 'glTF' };
  } catch (error) {
    const what = error instanceof RangeError ? `it is cut off, damaged or too large (${error.message})` : error.message;
    throw new Error(`${name} cannot be opened as ${type.toUpperCase()}: ${what}`);
  }
}
