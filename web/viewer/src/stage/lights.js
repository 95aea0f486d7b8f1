// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Light: for clay a lamp beside the camera; for materials a sun that stays, its shadows, and a room that is mirrored.
import { DirectionalLight, HemisphereLight, PCFShadowMap, PMREMGenerator } from 'three';

import { disposeStudio, makeStudio } from './studio.js';

const SUN = [0.55, -0.6, 1.1];
const SHADOW_SIDE = 2048;
/** Of what is mirrored; where no graphics card draws a large one would take seconds. */
const [SIDE, SMALL_SIDE] = [256, 32];

export class Lights {
  #renderer;
  #scene;
  #lamp = new DirectionalLight(0xffffff, 2.4);
  #sky = new HemisphereLight(0xffffff, 0x8090a0, 1.1);
  #sun = new DirectionalLight(0xfff0dc, 1.9);
  #room = null;
  #isSoftware;
  #isAuthored = false;

  constructor(renderer, scene, camera, { isSoftware }) {
    [this.#renderer, this.#scene, this.#isSoftware] = [renderer, scene, isSoftware];
    const hasShadows = !isSoftware;
    renderer.shadowMap.enabled = hasShadows;
    renderer.shadowMap.type = PCFShadowMap;
    this.#lamp.position.set(-0.4, 0.6, 1);
    this.#lamp.target.position.set(0, 0, -1);
    this.#sun.castShadow = hasShadows;
    this.#sun.shadow.mapSize.set(SHADOW_SIDE, SHADOW_SIDE);
    this.#sun.shadow.radius = 4;
    camera.add(this.#lamp, this.#lamp.target);
    scene.add(this.#sky, this.#sun);
    this.setAuthored(false, 1);
  }

  /** `diagonal`: of what is shown, around 0. */
  setAuthored(isAuthored, diagonal) {
    this.#isAuthored = isAuthored;
    if (isAuthored && !this.#isSoftware) this.#room ??= this.#makeRoom();
    this.#lamp.visible = !isAuthored;
    this.#sky.visible = !isAuthored || !this.#room;
    this.#sun.visible = isAuthored;
    this.#scene.environment = isAuthored ? this.#room : null;
    this.#scene.environmentIntensity = 0.6;
    this.#scene.environmentRotation.x = Math.PI / 2; // its up is y
    this.#sun.position.set(...SUN).setLength(diagonal);
    const { camera, normalBias } = this.#sun.shadow;
    Object.assign(camera, { left: -diagonal / 2, right: diagonal / 2, top: diagonal / 2, bottom: -diagonal / 2, near: diagonal / 4, far: 2 * diagonal });
    this.#sun.shadow.normalBias = Math.max(normalBias, diagonal / SHADOW_SIDE);
    camera.updateProjectionMatrix();
  }

  /** Without a graphics card what is mirrored takes long, and comes after the first picture. Whether there is more to be seen then. */
  finish() {
    if (!this.#isAuthored || this.#room) return false;
    this.#room = this.#makeRoom();
    this.#scene.environment = this.#room;
    this.#sky.visible = false;
    return true;
  }

  #makeRoom() {
    const generator = new PMREMGenerator(this.#renderer);
    const studio = makeStudio();
    const { texture } = generator.fromScene(studio, 0, 0.1, 100, { size: this.#isSoftware ? SMALL_SIDE : SIDE });
    generator.dispose();
    disposeStudio(studio);
    return texture;
  }
}
