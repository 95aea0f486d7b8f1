// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// .dmsh streams in Babylon.js. See deltamesh-extension.d.ts.
import { registerSceneLoaderPlugin } from '@babylonjs/core/Loading/sceneLoader.js';
import { AssetContainer } from '@babylonjs/core/assetContainer.js';
import { Mesh } from '@babylonjs/core/Meshes/mesh.js';
import { VertexData } from '@babylonjs/core/Meshes/mesh.vertexData.js';
import { SubMesh } from '@babylonjs/core/Meshes/subMesh.js';
import '@babylonjs/core/Materials/standardMaterial.js'; // what a mesh without a material is drawn with
import { DeltameshError } from '@deltamesh/decoder';
import { errorIn } from '@deltamesh/decoder/gltf';

const KINDS = { normal: 'normal', tangent: 'tangent', color: 'color', joints: 'matricesIndices', weights: 'matricesWeights' };
const MOST_UVS = 6;

/** As floats; integers that stand for [0, 1] or [-1, 1] become these. `isPart`: integers do so. */
function floatsOf(values, isPart) {
  if (values instanceof Float32Array) return values;
  const isSigned = values instanceof Int8Array || values instanceof Int16Array;
  const largest = isPart ? 2 ** (8 * values.BYTES_PER_ELEMENT - (isSigned ? 1 : 0)) - 1 : 1;
  return Float32Array.from(values, (value) => Math.max(-1, value / largest));
}

/** Colours have four components. */
function fourOf(values, components) {
  if (components === 4) return values;
  const four = new Float32Array((values.length / components) * 4).fill(1);
  for (let i = 0; i < values.length; ++i) four[4 * Math.floor(i / components) + (i % components)] = values[i];
  return four;
}

/** StandardMaterial takes sRGB. Alpha stays as it is. */
function srgbOf(floats) {
  const encode = (value) => (value <= 0.0031308 ? 12.92 * value : 1.055 * value ** (1 / 2.4) - 0.055);
  return floats.map((value, i) => (i % 4 === 3 ? value : encode(value)));
}

function kindOf(kind, count) {
  if (kind === 'uv') return count < MOST_UVS ? `uv${count === 0 ? '' : count + 1}` : undefined;
  return count === 0 ? KINDS[kind] : undefined;
}

/** Vertex numbers of the faces, those of a group together, with the groups' numbers and ranges. */
function facesByGroup({ indices, groups }) {
  if (!groups) return { sorted: indices, ranges: [[0, 0, indices.length]] };
  const order = Uint32Array.from(groups.keys()).sort((a, b) => groups[a] - groups[b] || a - b);
  const sorted = new Uint32Array(indices.length);
  const ranges = [];
  order.forEach((face, i) => {
    sorted.set(indices.subarray(3 * face, 3 * face + 3), 3 * i);
    if (ranges.at(-1)?.[0] === groups[face]) ranges.at(-1)[2] += 3;
    else ranges.push([groups[face], 3 * i, 3]);
  });
  return { sorted, ranges };
}

function toMesh(stream, name, scene) {
  const mesh = new Mesh(name, scene);
  const data = new VertexData();
  const { sorted, ranges } = facesByGroup(stream);
  data.positions = stream.positions;
  data.indices = sorted;
  data.applyToMesh(mesh);
  const counts = {};
  for (const { kind, components, normalized, linear, values } of stream.attributes) {
    const babylonKind = kindOf(kind, (counts[kind] = (counts[kind] ?? -1) + 1));
    if (!babylonKind) continue;
    const floats = floatsOf(values, normalized || kind === 'color');
    if (kind !== 'color') {
      mesh.setVerticesData(babylonKind, floats, false, components);
      continue;
    }
    const four = fourOf(floats, components);
    mesh.setVerticesData(babylonKind, linear ? srgbOf(four) : four, false, 4);
  }
  if (stream.groups) {
    mesh.subMeshes = [];
    for (const [group, start, count] of ranges) new SubMesh(group, 0, stream.positions.length / 3, start, count, mesh);
  }
  // Streams are right-handed, as glTF is.
  if (!scene.useRightHandedSystem) mesh.scaling.z = -1;
  const { origin, quality, chunks, geometry } = stream;
  mesh.metadata = { deltamesh: { origin, quality, geometry, attributes: stream.attributes.map(({ values, ...info }) => info), chunks } };
  return mesh;
}

/** `decode`: from bytes to a stream or a DeltameshError. Babylon.js keeps it until another takes its place. */
export function registerStreamLoader(decode) {
  const load = async (scene, data, fileName) => {
    const stream = await decode(data);
    if (stream instanceof DeltameshError) throw errorIn(fileName, stream);
    return toMesh(stream, (fileName || 'deltamesh').replace(/\.dmsh$/, ''), scene);
  };
  registerSceneLoaderPlugin({
    name: 'deltamesh',
    extensions: { '.dmsh': { isBinary: true } },
    loadFile(scene, source, rootUrl, onSuccess, onProgress, useArrayBuffer, onError) {
      if (!ArrayBuffer.isView(source)) return scene._loadFile(source, onSuccess, onProgress, true, true, onError);
      onSuccess(source);
      return null;
    },
    async importMeshAsync(names, scene, data, rootUrl, onProgress, fileName) {
      const meshes = [await load(scene, data, fileName)];
      const others = ['particleSystems', 'skeletons', 'animationGroups', 'transformNodes', 'geometries', 'lights', 'spriteManagers'];
      return { meshes, ...Object.fromEntries(others.map((kind) => [kind, []])) };
    },
    async loadAsync(scene, data, rootUrl, onProgress, fileName) {
      await load(scene, data, fileName);
    },
    async loadAssetContainerAsync(scene, data, rootUrl, onProgress, fileName) {
      const container = new AssetContainer(scene);
      const mesh = await load(scene, data, fileName);
      container.meshes.push(mesh);
      container.removeAllFromScene();
      return container;
    },
  });
}
