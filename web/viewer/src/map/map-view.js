// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// A map in the page: its parts are read, and only those that changed when its folder is opened again.
import { Superseded } from '../latest-job.js';
import { showScale } from '../panel/scale.js';
import { SEQUENTIAL as STOPS, roundLimit } from '../stage/heat.js';
import { formatBytes } from '../units.js';
import { keyOf } from './box.js';

export const MAP_SCALES = {
  bytes: { name: 'Size for each triangle', unit: 'bytes', colors: STOPS, valueOf: ({ bytes, triangleCount }) => bytes / Math.max(1, triangleCount) },
  error: { name: 'Visual error (VDE)', unit: 'units', colors: STOPS, valueOf: ({ quality }) => quality.vde },
};

export class MapView {
  #find;
  #job;
  #stage;
  #parts = [];
  #frame = null;
  #last = Promise.resolve();
  #opened = 0; // how often, so that what is no longer wanted ends
  #shown = 0; // the turn of what is shown

  /** `job`: a LatestJob of map-worker. */
  constructor(find, job, stage) {
    this.#find = find;
    this.#job = job;
    this.#stage = stage;
  }

  get isOpen() {
    return this.#frame !== null;
  }

  /** `files`: of mapOf(). Parts that changed are shown at once, in one frame. */
  async open({ manifest, parts: files }, onProgress) {
    const turn = ++this.#opened;
    const wanted = (result) => {
      if (turn !== this.#opened) throw new Superseded();
      return result;
    };
    const { parts, frame } = wanted(await this.#ask({ call: 'open', manifest, turn, shown: this.#shown, center: this.#frame?.center }));
    const { map } = this.#stage;
    const changed = parts.filter((part) => map.fileOf(keyOf(part)) !== part.file);
    const displays = [];
    for (const part of changed) {
      const file = files.get(part.file.split('/').pop());
      if (!file) throw new Error(`the map's folder does not have ${part.file}`);
      displays.push(wanted(await this.#ask({ call: 'part', turn, number: part.number, file })));
      onProgress(displays.length / changed.length);
    }
    const keys = new Set(parts.map(keyOf));
    for (const key of map.keys) if (!keys.has(key)) map.removePart(key);
    changed.forEach((part, i) => map.setPart(keyOf(part), part.file, displays[i]));
    this.#parts = parts;
    this.#shown = turn;
    if (!this.#frame) this.#stage.frame(frame.diagonal);
    this.#frame ??= frame;
  }

  /** The part `place` of the map from other bytes. */
  async replace(place, bytes) {
    const part = this.#parts[place];
    this.#stage.map.setPart(keyOf(part), part.file, await this.#ask({ call: 'part', turn: this.#shown, number: part.number, file: new Blob([bytes]) }));
  }

  /** One call after the other: new work would end the worker, which has the manifest. */
  #ask(message) {
    const answer = this.#last.then(() => this.#job.run(message));
    this.#last = answer.catch(() => {});
    return answer;
  }

  /** Gives up what is being opened; what is shown stays. */
  cancel() {
    ++this.#opened;
  }

  close() {
    this.cancel();
    this.#frame = null;
    this.#parts = [];
    this.#stage.map.empty();
  }

  show({ shading, mapColor }) {
    const scale = MAP_SCALES[mapColor];
    this.#stage.map.setShading(shading);
    if (scale) {
      const values = this.#parts.map(scale.valueOf);
      // Small parts of few triangles are far out.
      const limit = roundLimit(values.toSorted((a, b) => a - b)[Math.floor(0.9 * (values.length - 1))]);
      this.#stage.map.setColors(new Map(this.#parts.map((part, i) => [keyOf(part), Math.min(1, values[i] / limit)])), scale.colors);
      showScale(this.#find('scale'), { ...scale, isSigned: false }, limit);
    } else {
      this.#stage.map.setColors(null);
      showScale(this.#find('scale'), null);
    }
    this.#find('stage').dataset.view = 'map';
    this.#stage.setView('map');
    this.#stage.drawNew();
  }

  describe() {
    const sum = (of) => this.#parts.reduce((all, part) => all + of(part), 0);
    const triangles = sum(({ triangleCount }) => triangleCount);
    const bytes = sum((part) => part.bytes);
    return {
      title: `${this.#parts.length} parts, ${triangles.toLocaleString('en')} triangles`,
      summary: `${formatBytes(bytes)}, ${((8 * bytes) / Math.max(1, triangles)).toFixed(2)} bits per triangle`,
    };
  }
}
