// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Materials as the author of an asset meant them, for each group of faces.
import { EXTENSION_NAME } from '@deltamesh/decoder/gltf';
import { DoubleSide, FrontSide, Group, LoadingManager, MeshStandardMaterial } from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';

/** Of an example. */
export function plainMaterials(descriptions) {
  const make = ({ hasTwoSides, ...rest }) => new MeshStandardMaterial({ ...rest, side: hasTwoSides ? DoubleSide : FrontSide });
  return { materials: descriptions.map(make), missing: [] };
}

/** Meshes are the worker's: here they need not be read. */
const withoutMeshes = () => ({ name: 'without meshes', loadMesh: async () => new Group() });

/** White, in place of a texture that is not there. */
const BLANK =
  'data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mP8/5+hHgAHggJ/PchI7wAAAABJRU5ErkJggg==';

/** Buffers and textures that are files of their own are found by their names; nothing is fetched. */
function managerOf(others) {
  const urls = [];
  const missing = new Set();
  const manager = new LoadingManager();
  manager.setURLModifier((url) => {
    if (/^(data|blob):/.test(url)) return url;
    const name = decodeURIComponent(url).split('/').pop();
    const file = others.find((other) => other.name === name);
    if (!file) missing.add(name);
    if (!file) return BLANK;
    urls.push(URL.createObjectURL(file));
    return urls.at(-1);
  });
  return { manager, missing, release: () => urls.forEach((url) => URL.revokeObjectURL(url)) };
}

/** `numbers`: of the groups' materials, -1 for none. Returns these, and the names of files that were not given. */
export async function gltfMaterials(file, others, numbers) {
  const { manager, missing, release } = managerOf(others);
  try {
    const loader = new GLTFLoader(manager).register(withoutMeshes).register(() => ({ name: EXTENSION_NAME }));
    const { parser } = await loader.parseAsync(await file.arrayBuffer(), '');
    const known = new Map();
    for (const number of new Set(numbers)) known.set(number, number < 0 ? new MeshStandardMaterial() : await parser.getDependency('material', number));
    return { materials: numbers.map((number) => known.get(number)), missing: [...missing] };
  } finally {
    release();
  }
}
