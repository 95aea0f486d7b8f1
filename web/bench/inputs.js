// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// The meshes that are measured: of a corpus where there is one, else an example of the viewer's.
import { existsSync, readFileSync } from 'node:fs';
import { basename, join } from 'node:path';

import { Logger, NodeIO } from '@gltf-transform/core';
import { PLYLoader } from 'three/addons/loaders/PLYLoader.js';

import { meshOfGeometry } from '../viewer/src/mesh/from-geometry.js';
import { makeExample } from '../viewer/src/mesh/examples.js';

const FILES = [
  'paper/bunny_34834.ply',
  'models/dragon_100k.ply',
  'robot/kitchen_tsdf_20mm.ply',
  'gltf/FlightHelmet.glb',
  'gltf/2CylinderEngine.glb',
  'gltf/ClearCoatTest.glb',
  'gltf/Fox.glb',
  'formats/Duck.glb',
];
const KINDS = { NORMAL: 'normal', TANGENT: 'tangent', TEXCOORD: 'uv', COLOR: 'color', JOINTS: 'joints', WEIGHTS: 'weights' };

function readPly(path) {
  const { buffer, byteOffset, byteLength } = readFileSync(path);
  return [meshOfGeometry(new PLYLoader().parse(buffer.slice(byteOffset, byteOffset + byteLength)))];
}

const indicesOf = (primitive) => {
  const indices = primitive.getIndices()?.getArray();
  return indices ? Uint32Array.from(indices) : Uint32Array.from({ length: primitive.getAttribute('POSITION').getCount() }, (_, i) => i);
};

/** A mesh for each primitive, which is how Draco compresses glTF. */
async function readGlb(path) {
  const document = await new NodeIO().setLogger(new Logger(Logger.Verbosity.SILENT)).read(path);
  const primitives = document.getRoot().listMeshes().flatMap((mesh) => mesh.listPrimitives());
  return primitives.map((primitive) => ({
    positions: primitive.getAttribute('POSITION').getArray(),
    indices: indicesOf(primitive),
    groups: null,
    attributes: primitive.listSemantics().filter((semantic) => semantic !== 'POSITION').map((semantic) => {
      const accessor = primitive.getAttribute(semantic);
      return {
        name: semantic,
        kind: KINDS[semantic.split('_')[0]] ?? 'generic',
        components: accessor.getElementSize(),
        normalized: accessor.getNormalized(),
        linear: semantic.startsWith('COLOR_'),
        values: accessor.getArray(),
      };
    }),
  }));
}

/** Names with their meshes. `paths`: files; default those of the corpus in the folder that DELTAMESH_CORPUS names. */
export async function* inputs(paths) {
  const corpus = process.env.DELTAMESH_CORPUS;
  const files = paths.length > 0 ? paths : FILES.map((file) => join(corpus ?? '', file)).filter(existsSync);
  for (const file of files)
    yield { name: basename(file), meshes: file.endsWith('.glb') ? await readGlb(file) : readPly(file) };
  if (files.length === 0) yield { name: 'knot', meshes: [makeExample('knot').mesh] };
}
