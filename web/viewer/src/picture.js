// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// What is seen of the meshes: views, shading, heat, and what stands on them.
import { Player } from './panel/player.js';
import { showScale } from './panel/scale.js';
import { HEATS, heatLimit, heatTexture } from './stage/heat.js';
import { Model } from './stage/model.js';
import { NoStage } from './stage/no-stage.js';
import { Stage } from './stage/stage.js';
import { Superseded } from './latest-job.js';
import { formatSize } from './units.js';

/** Without WebGL the page works, but for pictures, and says so. */
function makeStage(find, drawing) {
  try {
    return new Stage(find('canvas'), drawing);
  } catch {
    find('no-picture').hidden = false;
    find('stage').classList.add('empty');
    find('view').hidden = true;
    find('still')?.remove();
    return new NoStage();
  }
}

export class Picture {
  #find;
  #workshop;
  #stage;
  #settings;
  #errors = null;
  #textures = {};
  #up = 'z';
  #hasMaterials = false;
  #frame;
  #source = null; // of the model: { places, count }
  #player;
  #onFailure;

  /** `drawing`: see Stage. `onFailure(error)`: of what the picture asks the workshop for. */
  constructor(find, workshop, drawing, onFailure) {
    this.#find = find;
    this.#onFailure = onFailure;
    this.#workshop = workshop;
    this.#stage = makeStage(find, drawing);
    this.#player = new Player(find, (number, time) => this.#pose(number, time));
    const theme = () => this.#stage.setBackground(getComputedStyle(find('stage')).backgroundColor);
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', theme);
    theme();
  }

  /** For a MapView. */
  get stage() {
    return this.#stage;
  }

  /** `up`: the file's. */
  setOriginal(display, frame, up) {
    const { diagonal } = frame;
    [this.#up, this.#frame, this.#source] = [up, frame, null];
    this.#player.show([]);
    this.#stage.original.setDisplay(display, diagonal / 2);
    this.#stage.frame(diagonal);
    this.setMaterials(null);
  }

  /** Of three.js, by groups, or null. */
  setMaterials(materials) {
    this.#hasMaterials = materials !== null;
    for (const which of ['original', 'result']) this.#stage[which].setMaterials(materials);
    if (materials) this.show(this.#settings);
  }

  /** An asset's { scene, animations }; `source`: { places, count } of its mesh. */
  setModel({ scene, animations }, source) {
    this.#source = source;
    this.#hasMaterials = true;
    const model = new Model(scene, animations, this.#frame);
    this.#stage.original.setModel(model);
    this.#player.show(model.clips);
    this.show(this.#settings);
  }

  #pose(number, time) {
    for (const which of ['original', 'result']) this.#stage[which].model?.pose(number, time);
    this.#stage.draw();
  }

  /** `display`, `order`: of the result. */
  setResult({ display, order }) {
    this.#errors = null;
    this.#stage.result.setDisplay(display, this.#stage.diagonal / 2);
    const { model } = this.#stage.original;
    if (!model) return;
    this.#stage.result.setModel(model.withVertices({ display, order }, this.#source.places, this.#source.count));
    this.#player.again();
  }

  /** Of the result, by vertices. */
  setErrors(errors) {
    this.#errors = errors;
  }

  /** When what is set is seen, or a second later. */
  whenSeen() {
    return Promise.race([this.#stage.whenDrawn(), new Promise((resolve) => setTimeout(resolve, 1000))]);
  }

  forgetResult() {
    this.#errors = null;
    this.#stage.result.empty();
    this.#find('label-original').textContent = 'Original';
    this.#find('label-result').textContent = 'Result';
  }

  setSizes(original, result) {
    this.#find('label-original').textContent = `Original, ${formatSize(original)}`;
    this.#find('label-result').textContent = `Result, ${formatSize(result)}`;
  }

  setSplit(share) {
    this.#stage.setSplit(share);
  }

  show(settings) {
    this.#settings = settings;
    const { view, look, up, shading, color } = settings;
    this.#stage.setUp(up === 'file' ? this.#up : up);
    this.#stage.showMaterials(this.#hasMaterials && look === 'own' && shading === 'smooth' && color === 'none');
    this.#stage.setView(view);
    this.#find('divider').hidden = view !== 'split';
    this.#find('label-original').hidden = view === 'result';
    this.#find('label-result').hidden = view === 'original';
    this.#find('stage').dataset.view = view;
    for (const which of ['original', 'result']) this.#shade(which, shading);
    this.#showHeat(color);
    this.#stage.drawNew();
  }

  #shade(which, shading) {
    const surface = this.#stage[which];
    surface.setShading(shading !== 'smooth');
    surface.showWires(shading === 'wire');
    if (shading === 'wire' && surface.geometry && !surface.hasWires) this.#makeWires(which, surface);
    this.#tellWires();
  }

  /** In the page, which of the meshes show their edges. */
  #tellWires() {
    const isShown = (which) => this.#settings.shading === 'wire' && this.#stage[which].hasWires;
    this.#find('stage').dataset.wires = ['original', 'result'].filter(isShown).join(' ');
  }

  async #makeWires(which, surface) {
    const { geometry } = surface;
    try {
      const edges = await this.#workshop.edges(which, surface);
      if (surface.geometry !== geometry || surface.hasWires) return;
      surface.setWires(edges);
      surface.showWires(this.#settings.shading === 'wire');
      this.#tellWires();
      this.#stage.drawNew();
    } catch (error) {
      if (!(error instanceof Superseded)) this.#onFailure(error);
    }
  }

  #showHeat(color) {
    const heat = this.#errors && HEATS[color];
    if (!heat) {
      this.#stage.result.setHeat(null);
      showScale(this.#find('scale'), null);
      return;
    }
    const values = this.#errors[color];
    const limit = heatLimit(values);
    const texture = (this.#textures[color] ??= heatTexture(heat.colors));
    this.#stage.result.setHeat(values, { texture, isSigned: heat.isSigned, limit });
    showScale(this.#find('scale'), heat, limit);
  }
}
