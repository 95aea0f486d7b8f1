// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Scenes with animations, skins and morph targets, as they are and with the vertices of a result.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { AnimationClip, Bone, BufferAttribute, BufferGeometry, Group, Mesh, MeshStandardMaterial, NumberKeyframeTrack, Skeleton, SkinnedMesh, Texture, Vector3, VectorKeyframeTrack } from 'three';

import { Model } from '../src/stage/model.js';

/** Of what has these sides: a Model is as large as its frame, with where its animation takes it up to three quarters of its time. */
const frameOf = (...sides) => ({ center: [0, 0, 0], diagonal: Math.hypot(...sides) });

function triangle(isIndexed = true) {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0]), 3));
  geometry.setAttribute('normal', new BufferAttribute(new Float32Array([0, 0, 1, 0, 0, 1, 0, 0, 1]), 3));
  if (isIndexed) geometry.setIndex([0, 1, 2]);
  return geometry;
}

const meshIn = (object) => {
  let found;
  object.traverse((child) => child.isMesh && (found = child));
  return found;
};

/** In the world, of the first mesh. */
function cornersOf(model) {
  model.updateMatrixWorld(true);
  const mesh = meshIn(model);
  if (mesh.isSkinnedMesh) mesh.skeleton.update();
  return [0, 1, 2].map((i) => mesh.localToWorld(mesh.getVertexPosition(i, new Vector3())).toArray().map((x) => Number(x.toFixed(4))));
}

/** A result whose vertices come in another order, each lifted by 0.25 in the world. */
const LIFTED = {
  display: { positions: new Float32Array([2, 1, 0.25, 2, 0, 0.25, 3, 0, 0.25]), normals: new Float32Array([0, 0, 1, 0, 0, 1, 0, 0, 1]), uvs: null },
  order: new Uint32Array([2, 0, 1]),
};

test('what the graphics card holds goes with the models: materials and textures with the first', () => {
  const map = new Texture();
  const scene = new Group().add(new Mesh(triangle(), new MeshStandardMaterial({ map })), new Mesh(triangle(), new MeshStandardMaterial({ map, emissiveMap: map })));
  const gone = [];
  for (const mesh of scene.children) {
    mesh.material.addEventListener('dispose', () => gone.push('material'));
    mesh.geometry.addEventListener('dispose', () => gone.push('geometry'));
  }
  let isClosed = false;
  map.source.data = { close: () => (isClosed = true) };
  map.addEventListener('dispose', () => gone.push('texture'));
  const model = new Model(scene, [], frameOf(1, 1));
  const result = model.withVertices(LIFTED, [{ start: 0, corners: null }, { start: 0, corners: null }], 3);
  result.dispose();
  assert.deepEqual(gone, [], 'the first model still has them');
  model.dispose();
  assert.deepEqual([...new Set(gone)].sort(), ['geometry', 'material', 'texture']);
  assert.equal(gone.filter((what) => what === 'material').length, 2);
  assert.ok(isClosed);
});

test('decoded vertices stand where the scene has them, and move with its animation', () => {
  const node = new Group();
  node.position.set(2, 0, 0);
  node.add(new Mesh(triangle(), new MeshStandardMaterial()));
  const scene = new Group().add(node);
  const track = new VectorKeyframeTrack(`${node.uuid}.position`, [0, 1], [2, 0, 0, 2, 4, 0]);
  const model = new Model(scene, [new AnimationClip('rise', 1, [track])], frameOf(1, 4));
  const result = model.withVertices(LIFTED, [{ start: 0, corners: null }], 3);
  assert.deepEqual(model.clips, [{ name: 'rise', duration: 1 }]);
  assert.deepEqual(cornersOf(model), [[2, 0, 0], [3, 0, 0], [2, 1, 0]]);
  assert.deepEqual(cornersOf(result), [[2, 0, 0.25], [3, 0, 0.25], [2, 1, 0.25]]);
  for (const [time, y] of [[0.25, 1], [0.5, 2]]) {
    for (const each of [model, result]) each.pose(0, time);
    assert.deepEqual(cornersOf(model)[0], [2, y, 0]);
    assert.deepEqual(cornersOf(result)[0], [2, y, 0.25]);
  }
});

test('a geometry without index has a vertex of the mesh for each corner', () => {
  const node = new Group();
  node.position.set(2, 0, 0);
  node.add(new Mesh(triangle(false), new MeshStandardMaterial()));
  const model = new Model(new Group().add(node), [], frameOf(1, 1));
  const result = model.withVertices(LIFTED, [{ start: 0, corners: new Uint32Array([0, 1, 2]) }], 3);
  assert.deepEqual(cornersOf(result), [[2, 0, 0.25], [3, 0, 0.25], [2, 1, 0.25]]);
});

test('morph targets are added to decoded vertices, at half weight half of them', () => {
  const geometry = triangle();
  geometry.morphAttributes.position = [new BufferAttribute(new Float32Array([0, 0, 2, 0, 0, 2, 0, 0, 2]), 3)];
  geometry.morphTargetsRelative = true;
  const mesh = new Mesh(geometry, new MeshStandardMaterial());
  mesh.position.set(2, 0, 0);
  const track = new NumberKeyframeTrack(`${mesh.uuid}.morphTargetInfluences`, [0, 1], [0, 1]);
  const model = new Model(new Group().add(mesh), [new AnimationClip('', 1, [track])], frameOf(1, 1, 1.5));
  const result = model.withVertices(LIFTED, [{ start: 0, corners: null }], 3);
  result.pose(0, 0.5);
  assert.deepEqual(cornersOf(result)[0], [2, 0, 1.25]);
});

test('skins move decoded vertices, and are as large as their frame', () => {
  const geometry = triangle();
  geometry.setAttribute('skinIndex', new BufferAttribute(new Uint16Array(12), 4));
  geometry.setAttribute('skinWeight', new BufferAttribute(new Float32Array([1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0]), 4));
  const mesh = new SkinnedMesh(geometry, new MeshStandardMaterial());
  const bone = new Bone();
  const scene = new Group().add(bone, mesh);
  scene.updateMatrixWorld(true);
  mesh.bind(new Skeleton([bone]));
  const track = new VectorKeyframeTrack(`${bone.uuid}.position`, [0, 1], [0, 0, 0, 0, 0, 8]);
  const model = new Model(scene, [new AnimationClip('jump', 1, [track])], frameOf(2, 2, 12));
  const display = { ...LIFTED.display, positions: new Float32Array([0, 1, 0.25, 0, 0, 0.25, 1, 0, 0.25]) };
  const result = model.withVertices({ display, order: LIFTED.order }, [{ start: 0, corners: null }], 3);
  const [own, decoded] = [model, result].map(cornersOf);
  const scale = 2;
  assert.equal(Number((own[1][0] - own[0][0]).toFixed(3)), Number(scale.toFixed(3)));
  assert.equal(Number((decoded[0][2] - own[0][2]).toFixed(3)), Number((0.25 * scale).toFixed(3)));
  result.pose(0, 0.5);
  assert.equal(Number((cornersOf(result)[0][2] - decoded[0][2]).toFixed(3)), Number((4 * scale).toFixed(3)));
});
