// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// A map that changes in the page. The camera follows its size until a person moves it; the key that shows all gives it back.
import { showScale } from '../panel/scale.js';
import { formatSize } from '../units.js';
import { keyOf } from './box.js';

const TEXT_MILLISECONDS = 250;
const MOST_OFF = 0.1; // of the diagonal, until the camera follows

function age(seconds) {
  return `${seconds < 10 ? seconds.toFixed(1) : Math.round(seconds)} s ago`;
}

export class LiveView {
  #find;
  #start;
  #stage;
  #status;
  #worker = null;
  #triangles = new Map(); // by parts
  #framed = null;
  #isTouched = false;
  #shading;
  #problem = '';
  #told = 0; // when

  /** `start(message)`: a live-worker that has got it. */
  constructor(find, start, stage, status) {
    [this.#find, this.#start, this.#stage, this.#status] = [find, start, stage, status];
    const canvas = find('canvas');
    for (const event of ['pointerdown', 'wheel', 'keydown'])
      canvas.addEventListener(event, ({ key }) => (this.#isTouched = key !== '0' && key !== 'Home'), { passive: true });
  }

  get isOpen() {
    return this.#worker !== null;
  }

  /** `address`: of a WebSocket; `map`: the map's id. */
  open(address, map) {
    this.close();
    this.#isTouched = false;
    this.#status.tell(`Connecting to ${address}`, false);
    this.#find('mesh-name').textContent = 'Live map';
    const worker = (this.#worker = this.#start({ address, map }));
    worker.onmessage = ({ data }) => worker === this.#worker && this.#follow(data);
    worker.onerror = ({ message }) => worker === this.#worker && this.#status.fail(new Error(message || 'the worker failed'));
  }

  async #follow({ news, traffic, problem, failure }) {
    if (failure) return this.#status.fail(new Error(failure));
    if (news) this.#take(news);
    this.#tell(news, traffic, problem);
    await this.#stage.whenDrawn();
    this.#worker?.postMessage({ isFree: true });
  }

  #take({ parts, removed, frame }) {
    if (parts.length === 0 && removed.length === 0) return;
    const { map } = this.#stage;
    for (const key of removed) {
      map.removePart(keyOf(key));
      this.#triangles.delete(keyOf(key));
    }
    for (const { key, triangleCount, display } of parts) {
      map.setPart(keyOf(key), null, display);
      this.#triangles.set(keyOf(key), triangleCount);
    }
    this.#frame(frame);
    this.show({ shading: this.#shading });
  }

  #frame(frame) {
    if (!frame || this.#isTouched) return;
    const isFar = ({ middle, diagonal }) =>
      Math.hypot(...middle.map((value, axis) => value - frame.middle[axis])) > MOST_OFF * diagonal || Math.abs(frame.diagonal - diagonal) > MOST_OFF * diagonal;
    if (this.#framed && !isFar(this.#framed)) return;
    this.#framed = frame;
    this.#stage.map.position.fromArray(frame.middle).negate();
    this.#stage.frame(frame.diagonal);
  }

  #tell(news, { bytes, messages, changedSeconds }, problem) {
    if (problem !== this.#problem) {
      this.#problem = problem;
      if (problem) this.#status.fail(new Error(problem));
    }
    if (!problem && this.isOpen && this.#find('status').textContent !== 'Live') this.#status.tell('Live', false);
    const now = performance.now();
    if (now - this.#told < TEXT_MILLISECONDS) return;
    this.#told = now;
    const count = (number, what) => `${number.toLocaleString('en')} ${what}`;
    const triangles = [...this.#triangles.values()].reduce((sum, some) => sum + some, 0);
    this.#find('mesh-name').textContent = `Live map: ${count(this.#triangles.size, 'parts')}, ${count(triangles, 'triangles')}`;
    this.#find('label-result').hidden = changedSeconds === null;
    if (changedSeconds !== null) this.#find('label-result').textContent = `Changed ${age(changedSeconds)}`;
    const missing = news?.lackingCount ? `; ${count(news.lackingCount, 'parts are on the way')}` : '';
    const faults = news?.faultCount ? `; ${count(news.faultCount, 'parts cannot be sent as they should')}` : '';
    this.#find('summary').textContent = `${formatSize(bytes)} in ${count(messages, 'messages')}${missing}${faults}`;
  }

  show({ shading }) {
    this.#shading = shading;
    this.#stage.map.setShading(shading);
    this.#stage.map.setColors(null);
    showScale(this.#find('scale'), null);
    this.#find('stage').dataset.view = 'map';
    this.#stage.setView('map');
    this.#stage.drawNew();
  }

  close() {
    this.#worker?.terminate();
    this.#worker = null;
    this.#framed = null;
    this.#problem = '';
    this.#triangles.clear();
    this.#stage.map.empty();
    this.#stage.map.position.set(0, 0, 0);
  }
}
