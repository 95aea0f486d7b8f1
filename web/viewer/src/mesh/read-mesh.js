// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Files become meshes that the encoder takes, by the loaders of three.js. For workers.
import { DeltameshError, createDecoder } from '@deltamesh/decoder';
import { DeltameshLoader, gltfDeltameshExtension } from '@deltamesh/three';
import { MeshoptDecoder } from 'meshoptimizer/decoder';
import { LoadingManager } from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { OBJLoader } from 'three/addons/loaders/OBJLoader.js';
import { PLYLoader } from 'three/addons/loaders/PLYLoader.js';
import { STLLoader } from 'three/addons/loaders/STLLoader.js';

import { meshOfGeometry } from './from-geometry.js';
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

/** `onMesh`: gets those of three.js, in the groups' order. */
function meshesOf(object, options, onMesh) {
  const meshes = [];
  object.updateMatrixWorld(true);
  object.traverse((child) => {
    if (!child.isMesh) return;
    onMesh?.(child);
    meshes.push(meshOfGeometry(child.geometry.clone().applyMatrix4(child.matrixWorld), options));
  });
  if (meshes.length === 0) throw new Error('it has no triangles');
  return joinMeshes(meshes);
}

function readObj(buffer) {
  const text = new TextDecoder().decode(buffer);
  const group = new OBJLoader().parse(text);
  // Without normals in the file the loader makes those of faces.
  if (!/^\s*vn\s/m.test(text)) group.traverse(({ geometry }) => geometry?.deleteAttribute('normal'));
  return { ...meshesOf(group), up: 'y' };
}

/** The page reads materials with their textures itself. */
const withoutTextures = () => ({ name: 'without textures', loadTexture: async () => null });

/** Nothing is fetched: what a file names must be within it. */
function withinFile(url) {
  if (!/^(data|blob):/.test(url)) throw new Error(`it needs ${url}, which is not a part of it`);
  return url;
}

async function readGltf(buffer, { others }) {
  const deltamesh = new DeltameshLoader(undefined, { workers: 0 });
  const manager = new LoadingManager().setURLModifier(withinFile);
  const loader = new GLTFLoader(manager).setMeshoptDecoder(MeshoptDecoder).register(gltfDeltameshExtension(deltamesh)).register(withoutTextures);
  const { scene, parser } = await loader.parseAsync(withOtherFiles(buffer, others), '');
  deltamesh.dispose();
  const materials = [];
  const mesh = meshesOf(scene, { isLinear: true }, (child) => {
    const { meshes, primitives = 0 } = parser.associations.get(child) ?? {};
    materials.push(parser.json.meshes[meshes]?.primitives[primitives].material ?? -1);
  });
  return { ...mesh, up: 'y', materials };
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
 * `others`: files that a .gltf may need. `modules`: the decoder's. With the mesh come `up`, the axis, and of glTF `materials`, their numbers
 * by groups, -1 for none, and `isGlb`. Throws what a person can read.
 */
export async function readMesh(file, { others = [], modules }) {
  const { name, size } = file;
  if (size === 0) throw new Error(`${name} is empty`);
  const buffer = await file.arrayBuffer();
  const type = typeOf(name, buffer);
  if (!READERS[type]) throw new Error(`${name} is none of ${MESH_SUFFIXES.join(', ').toUpperCase()}`);
  try {
    const { up = 'z', materials = null, ...mesh } = await READERS[type](buffer, { others, modules });
    check(mesh);
    return { mesh: { origin: [0, 0, 0], ...mesh }, up, materials, isGlb: type === 'glb' && magicOf(buffer) === 'glTF' };
  } catch (error) {
    const what = error instanceof RangeError ? `it is cut off, damaged or too large (${error.message})` : error.message;
    throw new Error(`${name} cannot be opened as ${type.toUpperCase()}: ${what}`);
  }
}
