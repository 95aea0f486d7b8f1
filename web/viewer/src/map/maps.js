// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// The map in the page: one from a folder, or one that changes.
import { LiveView } from './live-view.js';
import { mapOf } from './map-files.js';
import { MapView } from './map-view.js';

/** That of `live`, which may be relative to the page's address. */
function socketAddress(live) {
  const url = new URL(live, location.href);
  url.protocol = { 'http:': 'ws:', 'https:': 'wss:' }[url.protocol] ?? url.protocol;
  if (!/^wss?:$/.test(url.protocol)) throw new Error(`${live} is not the address of a WebSocket`);
  return url.href;
}

export class Maps {
  #find;
  #status;
  #controls;
  #settings;
  #onOpen;
  #folder;
  #live;

  /** `settings()`: the page's; `onOpen()`: when a map takes the place of a mesh. */
  constructor(find, { workshop, stage, status, controls, settings, onOpen }) {
    [this.#find, this.#status, this.#controls, this.#settings, this.#onOpen] = [find, status, controls, settings, onOpen];
    this.#folder = new MapView(find, workshop.map, stage);
    this.#live = new LiveView(find, (message) => workshop.follow(message), stage, status);
  }

  get isOpen() {
    return this.#folder.isOpen || this.#live.isOpen;
  }

  #opened(isLive) {
    this.#onOpen();
    this.#controls.showMap(this.#find, true, isLive);
    this.show();
  }

  /** Of a folder that is open the parts that changed. */
  async openFolder(files) {
    this.#status.tell('Reading the map');
    try {
      const map = mapOf(files);
      if (!map) throw new Error('this folder has no map: there is no map.dmm');
      if (this.#live.isOpen) this.#live.close();
      await this.#folder.open(map, (share) => (this.#find('progress').value = share));
      this.#opened(false);
      const { title, summary } = this.#folder.describe();
      this.#find('mesh-name').textContent = `Map: ${title}`;
      this.#find('summary').textContent = summary;
      this.#status.tell('Done', false);
    } catch (error) {
      this.#status.fail(error);
    }
  }

  /** `live`: address of a WebSocket; `map`: text of the map's id. */
  follow(live, map) {
    try {
      if (!/^\d{1,19}$/.test(map)) throw new Error(`${map} is not the number of a map`);
      const address = socketAddress(live);
      this.#folder.close();
      this.#live.open(address, BigInt(map));
      this.#opened(true);
    } catch (error) {
      this.#status.fail(error);
    }
  }

  /** The part `place` of a folder's map from other bytes. */
  async replace(place, bytes) {
    await this.#folder.replace(place, bytes);
    this.show();
  }

  show() {
    if (this.#live.isOpen) this.#live.show(this.#settings());
    else this.#folder.show(this.#settings());
  }

  /** Gives up what is being opened; what is shown stays. */
  cancel() {
    this.#folder.cancel();
  }

  close() {
    this.#folder.close();
    this.#live.close();
    this.#controls.showMap(this.#find, false);
  }
}
