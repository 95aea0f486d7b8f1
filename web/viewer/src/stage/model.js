// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// An asset's scene with its animations: as it was, or with the vertices of a result.
import { AnimationMixer, Box3, BufferAttribute, Group, Matrix4, Vector3 } from 'three';
import { clone } from 'three/addons/utils/SkeletonUtils.js';

/** The decoded vertex for each of the source's, or -1. */
function inverseOf(order, count) {
  const inverse = new Int32Array(count).fill(-1);
  order.forEach((vertex, decoded) => (inverse[vertex] = decoded));
  return inverse;
}

/** Rows of `values` moved by a matrix of 4 x 4 in columns, as `isDirection` made 1 long; `from`: the row for each vertex, or -1 for the `old` one. */
function moved(values, { elements: e }, { from, old, isDirection }) {
  const array = new Float32Array(3 * from.length);
  const w = isDirection ? 0 : 1;
  for (let vertex = 0, at = 0; vertex < from.length; ++vertex, at += 3) {
    const row = 3 * from[vertex];
    if (row < 0) {
      for (let i = 0; i < 3; ++i) array[at + i] = old.getComponent(vertex, i);
      continue;
    }
    const [x, y, z] = [values[row], values[row + 1], values[row + 2]];
    const a = e[0] * x + e[4] * y + e[8] * z + e[12] * w;
    const b = e[1] * x + e[5] * y + e[9] * z + e[13] * w;
    const c = e[2] * x + e[6] * y + e[10] * z + e[14] * w;
    const scale = isDirection ? 1 / (Math.hypot(a, b, c) || 1) : 1;
    array[at] = a * scale;
    array[at + 1] = b * scale;
    array[at + 2] = c * scale;
  }
  return array;
}

function picked(values, { from, old }) {
  const array = new Float32Array(2 * from.length);
  for (let vertex = 0; vertex < from.length; ++vertex) {
    for (let i = 0; i < 2; ++i) array[2 * vertex + i] = from[vertex] < 0 ? old.getComponent(vertex, i) : values[2 * from[vertex] + i];
  }
  return array;
}

/** A mesh's geometry with vertices of `display`, and all else as it is; `inverse`: of inverseOf(). */
function withDisplay({ geometry, matrixWorld }, { start, corners }, { positions, normals, uvs }, inverse, center) {
  const { attributes } = geometry;
  const from = Int32Array.from({ length: attributes.position.count }, (_, vertex) => inverse[start + (corners ? corners[vertex] : vertex)]);
  const toLocal = matrixWorld.clone().invert().multiply(new Matrix4().makeTranslation(...center));
  const made = geometry.clone();
  made.setAttribute('position', new BufferAttribute(moved(positions, toLocal, { from, old: attributes.position }), 3));
  if (attributes.normal) {
    const turn = matrixWorld.clone().transpose();
    made.setAttribute('normal', new BufferAttribute(moved(normals, turn, { from, old: attributes.normal, isDirection: true }), 3));
  }
  if (attributes.uv && uvs) made.setAttribute('uv', new BufferAttribute(picked(uvs, { from, old: attributes.uv }), 2));
  return made;
}

/** Fewer are measured one by one, in several poses. */
const MOST_VERTICES = 200000;

const meshesIn = (scene) => {
  const meshes = [];
  scene.traverse((child) => child.isMesh && meshes.push(child));
  return meshes;
};

function disposeMaterial(material) {
  for (const value of Object.values(material)) {
    if (!value?.isTexture) continue;
    value.dispose();
    value.source.data?.close?.(); // of an ImageBitmap
  }
  material.dispose();
}

export class Model extends Group {
  #scene;
  #isOwner;
  #mixer;
  #animations;

  /** `frame`: of the flattened mesh, whose size and place it takes; `like`: a Model that has them already. */
  constructor(scene, animations, frame, like) {
    super();
    [this.#scene, this.#animations, this.frame, this.#isOwner] = [scene, animations, frame, !like];
    // Tracks find unnamed nodes by their UUID, which copies do not have.
    scene.traverse((child) => (child.name ||= child.uuid));
    for (const mesh of meshesIn(scene)) {
      mesh.castShadow = mesh.receiveShadow = true;
      mesh.frustumCulled = false; // skins leave their boxes
    }
    this.add(scene);
    this.#mixer = new AnimationMixer(scene);
    if (like) this.scale.copy(like.scale);
    if (like) this.position.copy(like.position);
    else this.#fit();
  }

  /** As large as its frame, with its instances and where its first animation takes it. */
  #fit() {
    const { center, diagonal } = this.frame;
    const meshes = meshesIn(this.#scene);
    this.position.fromArray(center).negate();
    if (this.#animations.length === 0 && meshes.every(({ isSkinnedMesh, isInstancedMesh }) => !isSkinnedMesh && !isInstancedMesh)) return;
    const isSmall = meshes.reduce((sum, { geometry }) => sum + geometry.attributes.position.count, 0) < MOST_VERTICES;
    const times = isSmall ? [0, 0.25, 0.5, 0.75] : [0];
    const box = new Box3();
    for (const share of times) {
      this.pose(0, share * (this.#animations[0]?.duration ?? 0));
      this.#scene.updateMatrixWorld(true);
      box.expandByObject(this.#scene, isSmall);
    }
    this.pose(-1);
    const scale = diagonal / (box.getSize(new Vector3()).length() || diagonal);
    if (Math.abs(scale - 1) < 0.001) return;
    this.scale.setScalar(scale);
    box.getCenter(this.position).multiplyScalar(-scale);
  }

  get clips() {
    return this.#animations.map(({ name, duration }, i) => ({ name: name || `Animation ${i + 1}`, duration }));
  }

  /** The clip `number` at `time`, seconds. */
  pose(number, time) {
    this.#mixer.stopAllAction();
    if (!this.#animations[number]) return;
    this.#mixer.clipAction(this.#animations[number]).play();
    this.#mixer.setTime(time);
  }

  /** `result`: { display, order } of this scene's mesh; `places`: of meshesOf(). */
  withVertices({ display, order }, places, count) {
    this.pose(-1);
    this.#scene.removeFromParent();
    this.#scene.updateMatrixWorld(true); // as the reader had it
    const inverse = inverseOf(order, count);
    const geometries = meshesIn(this.#scene).map((mesh, i) => withDisplay(mesh, places[i], display, inverse, this.frame.center));
    const scene = clone(this.#scene);
    meshesIn(scene).forEach((mesh, i) => (mesh.geometry = geometries[i]));
    this.add(this.#scene);
    return new Model(scene, this.#animations, this.frame, this);
  }

  /** Materials and their textures go with the model that was there first: others have been disposed of by then. */
  dispose() {
    const meshes = meshesIn(this.#scene);
    for (const mesh of meshes) {
      mesh.geometry.dispose();
      mesh.skeleton?.dispose();
      if (mesh.isInstancedMesh) mesh.dispose();
    }
    if (this.#isOwner) new Set(meshes.flatMap(({ material }) => material)).forEach(disposeMaterial);
  }
}
