// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// A stream in Babylon.js by the imports of the package's README, and what any scene has.
import { ImportMeshAsync } from '@babylonjs/core/Loading/sceneLoader.js';
import '@babylonjs/loaders/glTF/index.js';
import { registerDeltamesh } from '@deltamesh/babylon';

import { FreeCamera } from '@babylonjs/core/Cameras/freeCamera.js';
import { Engine } from '@babylonjs/core/Engines/engine.js';
import { HemisphericLight } from '@babylonjs/core/Lights/hemisphericLight.js';
import { Vector3 } from '@babylonjs/core/Maths/math.vector.js';
import { Scene } from '@babylonjs/core/scene.js';

import { SIDE, pixelsOf } from './compare.js';

const canvas = document.body.appendChild(Object.assign(document.createElement('canvas'), { width: SIDE, height: SIDE }));
const scene = new Scene(new Engine(canvas, true, { preserveDrawingBuffer: true }));
new HemisphericLight('sky', new Vector3(0, 1, 0), scene);
registerDeltamesh();

/** Whether anything is seen of it. */
window.drawStream = async (url) => {
  const { meshes } = await ImportMeshAsync(url, scene);
  meshes[0].computeWorldMatrix(true);
  const { centerWorld: center, radiusWorld: radius } = meshes[0].getBoundingInfo().boundingSphere;
  const camera = new FreeCamera('camera', Vector3.Zero(), scene);
  camera.maxZ = 10 * radius;
  camera.minZ = radius / 100;
  await scene.whenReadyAsync();
  return [-1, 1].some((side) => {
    camera.position = center.add(new Vector3(0.3, 0.5, side).normalize().scale(3 * radius)); // surfaces have one side
    camera.setTarget(center);
    scene.render();
    const pixels = pixelsOf(canvas);
    return pixels.some((value, i) => value !== pixels[i % 4]);
  });
};
window.isReady = true;
