// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Draws assets with Babylon.js, in the page.
import { registerDeltamesh } from '@deltamesh/babylon';
import { FreeCamera } from '@babylonjs/core/Cameras/freeCamera.js';
import { Engine } from '@babylonjs/core/Engines/engine.js';
import { DirectionalLight } from '@babylonjs/core/Lights/directionalLight.js';
import { HemisphericLight } from '@babylonjs/core/Lights/hemisphericLight.js';
import { ImportMeshAsync } from '@babylonjs/core/Loading/sceneLoader.js';
import { Color4 } from '@babylonjs/core/Maths/math.color.js';
import { Vector3 } from '@babylonjs/core/Maths/math.vector.js';
import { Scene } from '@babylonjs/core/scene.js';
import '@babylonjs/core/Helpers/sceneHelpers.js';
import '@babylonjs/loaders/glTF/2.0/index.js';

import { SIDE, VIEWS, comparePictures, pixelsOf } from './compare.js';

const canvas = document.body.appendChild(Object.assign(document.createElement('canvas'), { width: SIDE, height: SIDE }));
const engine = new Engine(canvas, true, { preserveDrawingBuffer: true });
registerDeltamesh();

/** Sees all of `box` from a direction of VIEWS. */
function aim(scene, { min, max }, direction) {
  const center = min.add(max).scale(0.5);
  const size = max.subtract(min).length();
  const camera = new FreeCamera('camera', center.add(new Vector3(...direction).normalize().scale(1.3 * size)), scene);
  camera.setTarget(center);
  camera.minZ = size / 100;
  camera.maxZ = 4 * size;
  return camera;
}

async function open(url) {
  const scene = new Scene(engine);
  scene.clearColor = new Color4(0.2, 0.33, 0.47, 1);
  const { meshes } = await ImportMeshAsync(url, scene, { pluginExtension: '.glb' });
  new DirectionalLight('sun', new Vector3(-1, -2, -3), scene).intensity = 1;
  new HemisphericLight('sky', new Vector3(0, 1, 0), scene).intensity = 0.5;
  // Half of each morph target, so that they are seen, too.
  for (const { morphTargetManager: targets } of meshes)
    for (let i = 0; i < (targets?.numTargets ?? 0); ++i) targets.getTarget(i).influence = 0.5 / targets.numTargets;
  for (const group of scene.animationGroups) group.stop();
  return scene;
}

/** `share`: of the last animation. */
function pose(scene, share) {
  const group = scene.animationGroups.at(-1);
  if (!group) return;
  group.start();
  group.pause();
  group.goToFrame(group.from + share * (group.to - group.from));
}

/** A picture for each of VIEWS. */
async function draw(scene, box) {
  const pictures = [];
  for (const direction of VIEWS) {
    const camera = aim(scene, box, direction);
    await scene.whenReadyAsync();
    scene.render();
    pictures.push(pixelsOf(canvas));
    camera.dispose();
  }
  return pictures;
}

/** comparePictures() for each of `poses`, shares of the animation, and of VIEWS; `packed` is left on the canvas. */
window.compareAssets = async (plain, packed, poses) => {
  const scenes = [await open(plain), await open(packed)];
  const box = scenes[0].getWorldExtends();
  const compared = [];
  for (const share of poses) {
    for (const scene of scenes) pose(scene, share);
    const [before, after] = [await draw(scenes[0], box), await draw(scenes[1], box)];
    compared.push(...before.map((picture, view) => comparePictures(picture, after[view])));
  }
  for (const scene of scenes) scene.dispose();
  return compared;
};

/** The message of what goes wrong, or ''. */
window.tryToLoad = async (url) => {
  const scene = new Scene(engine);
  try {
    await ImportMeshAsync(url, scene);
    return '';
  } catch (error) {
    return error.message;
  } finally {
    scene.dispose();
  }
};
window.isReady = true;
