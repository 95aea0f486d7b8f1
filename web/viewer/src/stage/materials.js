// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Assets as their authors meant them: materials, textures, animations.
import { DoubleSide, FrontSide, LoadingManager, MeshStandardMaterial } from 'three';

import { gltfLoader } from '../mesh/gltf-loader.js';

/** Of an example. */
export function plainMaterials(descriptions) {
  const make = ({ hasTwoSides, ...rest }) => new MeshStandardMaterial({ ...rest, side: hasTwoSides ? DoubleSide : FrontSide });
  return descriptions.map(make);
}

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

/** What would shine white. */
function darken(scene) {
  scene.traverse(({ material }) => {
    for (const each of [material ?? []].flat()) if (each.emissiveMap?.image?.width === 1) each.emissive.set(0);
  });
}

const startWorker = () => new Worker(new URL('./decode-worker.js', import.meta.url), { type: 'module' });

/** { scene, animations } of three.js, and the names of files that were not given. */
export async function gltfScene(file, others) {
  const { manager, missing, release } = managerOf(others);
  const { loader, dispose } = gltfLoader(manager, { workers: 1, createWorker: startWorker });
  try {
    const { scene, animations } = await loader.parseAsync(await file.arrayBuffer(), '');
    if (missing.size > 0) darken(scene);
    return { scene, animations, missing: [...missing] };
  } finally {
    dispose();
    release();
  }
}
