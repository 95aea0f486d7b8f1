// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Draws assets with three.js, in the page.
import { DeltameshLoader, gltfDeltameshExtension } from '@deltamesh/three';
import { AnimationMixer, Box3, Color, DirectionalLight, HemisphereLight, PerspectiveCamera, Scene, Vector3, WebGLRenderer } from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';

import { SIDE, VIEWS, comparePictures, pixelsOf } from './compare.js';

const canvas = document.body.appendChild(Object.assign(document.createElement('canvas'), { width: SIDE, height: SIDE }));
const renderer = new WebGLRenderer({ canvas, antialias: true, preserveDrawingBuffer: true });
const camera = new PerspectiveCamera(40, 1);
const streams = new DeltameshLoader();
const loader = new GLTFLoader().register(gltfDeltameshExtension(streams));

/** Sees all of `box` from a direction of VIEWS. */
function aim(box, direction) {
  const size = box.getSize(new Vector3()).length();
  const center = box.getCenter(new Vector3());
  camera.position.copy(center).add(new Vector3(...direction).setLength(1.3 * size));
  camera.near = size / 100;
  camera.far = 4 * size;
  camera.lookAt(center);
  camera.updateProjectionMatrix();
}

async function open(url) {
  const { scene, animations } = await loader.loadAsync(url);
  const shown = new Scene();
  shown.background = new Color(0x335577);
  const sun = new DirectionalLight(0xffffff, 1.5);
  sun.position.set(1, 2, 3);
  shown.add(scene, sun, new HemisphereLight(0xffffff, 0x808080, 1));
  // Half of each morph target, so that they are seen, too.
  scene.traverse((object) => object.morphTargetInfluences?.fill(0.5 / object.morphTargetInfluences.length));
  const clip = animations.at(-1);
  const mixer = new AnimationMixer(scene);
  if (clip) mixer.clipAction(clip).play();
  /** `share`: of the last animation. */
  const pose = (share) => {
    if (clip) mixer.setTime(share * clip.duration);
    shown.updateMatrixWorld(true);
  };
  return { shown, pose };
}

function draw(scene) {
  renderer.render(scene, camera);
  return pixelsOf(canvas);
}

/** comparePictures() for each of `poses`, shares of the animation, and of VIEWS; `packed` is left on the canvas. */
window.compareAssets = async (plain, packed, poses) => {
  const assets = await Promise.all([plain, packed].map(open));
  return poses.flatMap((share) => {
    for (const { pose } of assets) pose(share);
    const box = new Box3().setFromObject(assets[0].shown.children[0]);
    return VIEWS.map((direction) => {
      aim(box, direction);
      return comparePictures(...assets.map(({ shown }) => draw(shown)));
    });
  });
};

/** The message of what goes wrong, or ''. */
window.tryToLoad = async (url) => {
  try {
    await (url.endsWith('.dmsh') ? streams : loader).loadAsync(url);
    return '';
  } catch (error) {
    return error.message;
  }
};

/** What goes wrong with each of many loaders that are all kept. */
window.loadByMany = (count, url) =>
  Promise.all(Array.from({ length: count }, () => new DeltameshLoader().loadAsync(url).then(() => '', (error) => error.message)));
/** The same of one whose worker is a file of the page's. */
window.loadByOwnWorker = (url) => {
  const createWorker = () => new Worker('/decoder-worker.js', { type: 'module' });
  return new DeltameshLoader(undefined, { createWorker }).loadAsync(url).then(() => '', (error) => error.message);
};
window.isReady = true;
