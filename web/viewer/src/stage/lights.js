// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Light: for clay a lamp beside the camera; for materials a sun that stays, its shadows where a graphics card draws, and a room that is mirrored.
import { DirectionalLight, HemisphereLight, PCFShadowMap } from 'three';

const SUN = [0.55, -0.6, 1.1];
const SHADOW_SIDE = 2048;

export class Lights {
  #scene;
  #lamp = new DirectionalLight(0xffffff, 2.4);
  #sky = new HemisphereLight(0xffffff, 0x8090a0, 1.1);
  #sun = new DirectionalLight(0xfff0dc, 1.9);
  #studio;
  #mirrored;
  #isAuthored = false;

  /** `studio`: of studioTexture(), or null. */
  constructor(renderer, scene, camera, { studio, isSoftware }) {
    const hasShadows = !isSoftware;
    [this.#scene, this.#studio, this.#mirrored] = [scene, studio, isSoftware ? null : studio];
    renderer.shadowMap.enabled = hasShadows;
    renderer.shadowMap.type = PCFShadowMap;
    this.#lamp.position.set(-0.4, 0.6, 1);
    this.#lamp.target.position.set(0, 0, -1);
    this.#sun.castShadow = hasShadows;
    this.#sun.shadow.mapSize.set(SHADOW_SIDE, SHADOW_SIDE);
    this.#sun.shadow.radius = 4;
    camera.add(this.#lamp, this.#lamp.target);
    scene.add(this.#sky, this.#sun);
    scene.environmentIntensity = 0.6;
    scene.environmentRotation.x = Math.PI / 2; // its up is y
    this.setAuthored(false, 1);
  }

  /** `diagonal`: of what is shown, around 0. */
  setAuthored(isAuthored, diagonal) {
    this.#isAuthored = isAuthored;
    this.#lamp.visible = !isAuthored;
    this.#sky.visible = !isAuthored || !this.#mirrored;
    this.#sun.visible = isAuthored;
    this.#scene.environment = isAuthored ? this.#mirrored : null;
    this.#sun.position.set(...SUN).setLength(diagonal);
    const { camera } = this.#sun.shadow;
    Object.assign(camera, { left: -diagonal / 2, right: diagonal / 2, top: diagonal / 2, bottom: -diagonal / 2, near: diagonal / 4, far: 2 * diagonal });
    this.#sun.shadow.normalBias = diagonal / SHADOW_SIDE;
    camera.updateProjectionMatrix();
  }

  /** Programs that mirror take the processor long to make: they come after the first picture. Whether there is more to be seen then. */
  finish() {
    if (!this.#isAuthored || this.#mirrored === this.#studio) return false;
    this.#mirrored = this.#scene.environment = this.#studio;
    this.#sky.visible = false;
    return true;
  }
}
