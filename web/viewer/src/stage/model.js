// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// An asset's scene with its animations: as it was, or with the vertices of a result.
import { AnimationMixer, Box3, BufferAttribute, Group, Matrix3, Matrix4, Vector3 } from 'three';
import { clone } from 'three/addons/utils/SkeletonUtils.js';

/** The decoded vertex for each of the source's, or -1. */
function inverseOf(order, count) {
  const inverse = new Int32Array(count).fill(-1);
  order.forEach((vertex, decoded) => (inverse[vertex] = decoded));
  return inverse;
}

/** Positions and directions of `display`, in the coordinates of a mesh of three.js. */
class Vertices {
  #place = new Vector3();

  constructor({ display, order, center, count }) {
    Object.assign(this, { display, center: new Vector3(...center), inverse: inverseOf(order, count) });
  }

  /** A geometry with them, and all else as it is. */
  putInto(mesh, { start, corners }) {
    const geometry = mesh.geometry.clone();
    const { positions, normals, uvs } = this.display;
    const toLocal = new Matrix4().copy(mesh.matrixWorld).invert();
    const turn = new Matrix3().setFromMatrix4(mesh.matrixWorld).transpose();
    const number = (vertex) => this.inverse[start + (corners ? corners[vertex] : vertex)];
    const put = (name, size, values, change) => {
      const old = geometry.attributes[name];
      if (!old || !values) return;
      const array = new Float32Array(size * old.count);
      for (let vertex = 0; vertex < old.count; ++vertex) {
        const from = number(vertex);
        if (from < 0) for (let i = 0; i < size; ++i) array[size * vertex + i] = old.getComponent(vertex, i);
        else change(values, from, array, vertex);
      }
      geometry.setAttribute(name, new BufferAttribute(array, size));
    };
    put('position', 3, positions, (values, from, array, to) => this.#place.fromArray(values, 3 * from).add(this.center).applyMatrix4(toLocal).toArray(array, 3 * to));
    put('normal', 3, normals, (values, from, array, to) => this.#place.fromArray(values, 3 * from).applyMatrix3(turn).normalize().toArray(array, 3 * to));
    put('uv', 2, uvs, (values, from, array, to) => array.set(values.subarray(2 * from, 2 * from + 2), 2 * to));
    return geometry;
  }
}

/** Of which several poses are measured. */
const MOST_VERTICES = 200000;

const meshesIn = (scene) => {
  const meshes = [];
  scene.traverse((child) => child.isMesh && meshes.push(child));
  return meshes;
};

export class Model extends Group {
  #scene;
  #mixer;
  #animations;

  /** `frame`: of the flattened mesh, whose size and place it takes. */
  constructor(scene, animations, frame) {
    super();
    [this.#scene, this.#animations, this.frame] = [scene, animations, frame];
    // Tracks find unnamed nodes by their UUID, which copies do not have.
    scene.traverse((child) => (child.name ||= child.uuid));
    for (const mesh of meshesIn(scene)) {
      mesh.castShadow = mesh.receiveShadow = true;
      mesh.frustumCulled = false; // skins leave their boxes
    }
    this.add(scene);
    this.#mixer = new AnimationMixer(scene);
    this.#fit();
  }

  /** As large as its frame, with its instances and where its first animation takes it. */
  #fit() {
    const { center, diagonal } = this.frame;
    const vertices = meshesIn(this.#scene).reduce((sum, { geometry }) => sum + geometry.attributes.position.count, 0);
    const times = this.#animations.length > 0 && vertices < MOST_VERTICES ? [0, 0.25, 0.5, 0.75] : [0];
    const box = new Box3();
    for (const share of times) {
      this.pose(0, share * (this.#animations[0]?.duration ?? 0));
      this.#scene.updateMatrixWorld(true);
      box.expandByObject(this.#scene, true);
    }
    this.pose(-1);
    const scale = diagonal / (box.getSize(new Vector3()).length() || diagonal);
    const isSame = Math.abs(scale - 1) < 0.001;
    this.scale.setScalar(isSame ? 1 : scale);
    const middle = isSame ? new Vector3(...center) : box.getCenter(new Vector3());
    this.position.copy(middle).multiplyScalar(-this.scale.x);
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
    const vertices = new Vertices({ display, order, center: this.frame.center, count });
    const geometries = meshesIn(this.#scene).map((mesh, i) => vertices.putInto(mesh, places[i]));
    const scene = clone(this.#scene);
    meshesIn(scene).forEach((mesh, i) => (mesh.geometry = geometries[i]));
    this.add(this.#scene);
    const model = new Model(scene, this.#animations, this.frame);
    [model.scale, model.position].forEach((value, i) => value.copy([this.scale, this.position][i]));
    return model;
  }

  dispose() {
    for (const { geometry } of meshesIn(this.#scene)) geometry.dispose();
  }
}
