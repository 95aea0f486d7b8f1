// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// The canvas: original and result with one camera, side by side or split.
import { Color, NeutralToneMapping, PerspectiveCamera, Scene, Vector2, WebGLRenderer } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';

import { MapSurface } from '../map/map-surface.js';
import { moveByKeys } from './keys.js';
import { Lights } from './lights.js';
import { studioTexture } from './studio.js';
import { Surface } from './surface.js';

const FIELD_OF_VIEW = 40;

/**
 * Parts of the canvas from `from` to `to`, shares of its width; `isWhole`: the camera sees all of the width. The result comes first: its
 * arrays are the new ones, which would wait for what is drawn before them.
 */
function panesOf(view, split) {
  if (view === 'side') return [{ name: 'result', from: 0.5, to: 1 }, { name: 'original', from: 0, to: 0.5 }];
  if (view === 'split') {
    return [{ name: 'result', from: split, to: 1, isWhole: true }, { name: 'original', from: 0, to: split, isWhole: true }];
  }
  return [{ name: view, from: 0, to: 1 }];
}

export class Stage {
  original = new Surface();
  result = new Surface();
  map = new MapSurface();
  #scene = new Scene();
  #camera = new PerspectiveCamera(FIELD_OF_VIEW, 1, 0.01, 100);
  #renderer;
  #controls;
  #lights;
  #view = 'side';
  #split = 0.5;
  #isWaiting = false;
  #isNew = true; // programs may be missing
  #waiting = []; // who waits for a picture that is not begun
  #drawing = null; // who waits for the picture that is being drawn
  #fence = null; // behind what was last given to the graphics card

  /** `isSoftware`: whether the processor draws; `studio`: of fetchStudio(), or null. */
  constructor(canvas, { isSoftware, studio }) {
    this.#renderer = new WebGLRenderer({ canvas, antialias: !isSoftware });
    this.#renderer.toneMapping = NeutralToneMapping; // of materials alone
    this.#renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.#lights = new Lights(this.#renderer, this.#scene, this.#camera, { isSoftware, studio: studio && studioTexture(studio) });
    this.#scene.add(this.#camera, this.original, this.result, this.map);
    this.#controls = new OrbitControls(this.#camera, canvas);
    this.#controls.addEventListener('change', () => this.draw());
    moveByKeys(canvas, this.#camera, this.#controls, () => this.frame());
    new ResizeObserver(() => this.#resize()).observe(canvas.parentElement);
    this.#resize();
  }

  setView(view) {
    this.#view = view;
    this.draw();
  }

  /** Share of the width that the original has. */
  setSplit(split) {
    this.#split = split;
    this.draw();
  }

  /** 'y' or 'z': of the meshes; the scene's is z. */
  setUp(up) {
    for (const surface of [this.original, this.result]) surface.rotation.x = up === 'y' ? Math.PI / 2 : 0;
    this.draw();
  }

  /** Materials in the light that they were made for, or clay in that of a workshop. */
  showMaterials(isShown) {
    for (const surface of [this.original, this.result]) surface.showMaterials(isShown);
    this.#lights.setAuthored(isShown, this.diagonal);
    this.draw();
  }

  setBackground(color) {
    this.#scene.background = new Color(color);
    this.draw();
  }

  /** The camera sees all of a mesh with this diagonal, around 0. */
  frame(diagonal = this.diagonal) {
    this.diagonal = diagonal;
    const distance = (0.55 * diagonal) / Math.tan((FIELD_OF_VIEW * Math.PI) / 360); // some meshes reach the corners of their box, and the nearest are larger
    this.#camera.near = distance / 200;
    this.#camera.far = distance * 20;
    this.#camera.position.set(0.35, -0.75, 0.55).setLength(distance);
    this.#camera.up.set(0, 0, 1);
    this.#controls.target.set(0, 0, 0);
    this.#controls.update();
    this.draw();
  }

  /** As draw(), of what has not been seen before: first the graphics card makes its programs, while the page goes on. */
  drawNew() {
    this.#isNew = true;
    this.draw();
  }

  /** With the next frame for which the graphics card is free: to hand more to one that is busy would stop the page. */
  draw() {
    if (this.#isWaiting) return;
    this.#isWaiting = true;
    this.#renderer.domElement.dataset.picture = 'waiting';
    requestAnimationFrame(() => this.#attempt());
  }

  #attempt() {
    if (this.#isBusy() || !this.#hasPrograms()) return requestAnimationFrame(() => this.#attempt());
    if (this.#isNew) {
      this.#isNew = false;
      this.#renderer.compile(this.#scene, this.#camera);
      this.#setFence();
      return requestAnimationFrame(() => this.#attempt());
    }
    this.#isWaiting = false;
    this.#drawNow();
    this.#drawing = this.#waiting.splice(0);
    this.#setFence();
    return this.#follow();
  }

  /** Whether those that were begun are made: to draw with others would wait for them. */
  #hasPrograms() {
    return this.#renderer.info.programs.every((program) => program.isReady());
  }

  #setFence() {
    const gl = this.#renderer.getContext();
    this.#fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
  }

  /** Until what is drawn is seen; where more is to be drawn, #attempt() does the same. */
  #follow() {
    if (!this.#isWaiting && this.#isBusy()) requestAnimationFrame(() => this.#follow());
  }

  /** When what was last asked for is seen; at once where nobody sees the page. */
  whenDrawn() {
    const list = this.#isWaiting ? this.#waiting : this.#drawing;
    if (!list || document.hidden) return undefined;
    return new Promise((resolve) => list.push(resolve));
  }

  #isBusy() {
    const gl = this.#renderer.getContext();
    // A fence of a context that was lost and restored has no status.
    if (this.#fence && !gl.isContextLost() && gl.getSyncParameter(this.#fence, gl.SYNC_STATUS) === gl.UNSIGNALED) return true;
    if (this.#fence) gl.deleteSync(this.#fence);
    this.#fence = null;
    this.#tellDrawn();
    return false;
  }

  /** In the page, too, whether the picture is that of what was last asked for. */
  #tellDrawn() {
    if (!this.#drawing) return;
    for (const resolve of this.#drawing) resolve();
    this.#drawing = null;
    if (!this.#isWaiting) this.#renderer.domElement.dataset.picture = 'drawn';
    if (!this.result.geometry) return;
    if (performance.getEntriesByName('first picture').length === 0) performance.mark('first picture');
    document.getElementById('still')?.remove();
    if (this.#lights.finish()) this.drawNew();
  }

  #resize() {
    const { clientWidth, clientHeight } = this.#renderer.domElement.parentElement;
    if (clientWidth === 0 || clientHeight === 0) return;
    const { x, y } = this.#renderer.getSize(new Vector2());
    if (x === clientWidth && y === clientHeight) return; // what an observer tells first: a new canvas would wait for the graphics card
    this.#renderer.setSize(clientWidth, clientHeight, false);
    this.draw();
  }

  #drawNow() {
    const { clientWidth: width, clientHeight: height } = this.#renderer.domElement;
    this.#renderer.setScissorTest(true);
    for (const { name, from, to, isWhole } of panesOf(this.#view, this.#split)) {
      const [left, size] = isWhole ? [0, width] : [from * width, (to - from) * width];
      this.#camera.aspect = size / height;
      // Where it is narrow the field of view is that of the width.
      this.#camera.zoom = Math.min(1, this.#camera.aspect);
      this.#camera.updateProjectionMatrix();
      this.#renderer.setViewport(left, 0, size, height);
      this.#renderer.setScissor(from * width, 0, (to - from) * width, height);
      this.original.visible = name === 'original';
      this.result.visible = name === 'result';
      this.map.visible = name === 'map';
      this.#renderer.render(this.#scene, this.#camera);
    }
  }
}
