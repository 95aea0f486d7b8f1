// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// What materials mirror: a room with large lamps, made of boxes that shine by themselves, so that one short program draws all of it. Y is up.
import { BackSide, BoxGeometry, Mesh, MeshBasicMaterial, Scene } from 'three';

/** Size, place and light: [red, green, blue], 1 is white. */
const LAMPS = [
  [[7, 0.2, 3], [0, 5.6, 0], [9, 9, 8.6]],
  [[0.2, 3, 5], [-6.6, 2.2, 1], [6, 6.4, 7.2]],
  [[3, 2.4, 0.2], [2.5, 2.4, -6.6], [7.5, 6.6, 5.4]],
  [[0.2, 2, 1.2], [6.6, 1.6, 2.5], [4.5, 4.2, 3.8]],
  [[14, 0.2, 14], [0, -2.2, 0], [0.34, 0.3, 0.27]],
];
const WALLS = [0.62, 0.64, 0.68];

function box(size, place, light, side) {
  const material = new MeshBasicMaterial({ toneMapped: false, ...(side === undefined ? {} : { side }) });
  material.color.setRGB(...light);
  const mesh = new Mesh(new BoxGeometry(...size), material);
  mesh.position.set(...place);
  return mesh;
}

export function makeStudio() {
  const scene = new Scene();
  scene.add(box([14, 9, 14], [0, 2, 0], WALLS, BackSide), ...LAMPS.map(([size, place, light]) => box(size, place, light)));
  return scene;
}

export function disposeStudio(scene) {
  for (const { geometry, material } of scene.children) {
    geometry.dispose();
    material.dispose();
  }
}
