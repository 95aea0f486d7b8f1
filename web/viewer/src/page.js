// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// The page: settings in, streams and pictures out.
import { listen } from './inputs.js';
import { Maps } from './map/maps.js';
import { EXAMPLES, exampleOf } from './mesh/examples.js';
import { Controls } from './panel/controls.js';
import { headlineOf } from './panel/headline.js';
import { fetchFile, oneMeshOf } from './panel/open.js';
import { compareWithOthers } from './panel/others.js';
import { forgetResult, rawBytes, showResult } from './panel/result.js';
import { Status } from './panel/status.js';
import { Picture } from './picture.js';
import { gltfScene, plainMaterials } from './stage/materials.js';
import { ENCODING, asPrepared, changed, encodeOptions, fromHash, toHash } from './settings.js';

/** A slider on the move does not start work at each step. */
const PAUSE_MILLISECONDS = 200;

const find = (id) => document.getElementById(id);

/** What takes long is done in several tasks, between which people are heard. */
const nextTask = () => new Promise((resolve) => setTimeout(resolve));

export class Page {
  #settings = fromHash(location.hash);
  #source = null;
  #result = null;
  #name = '';
  #timer = 0;
  #opening = 0; // counts what was opened, and what was asked of it: what comes of an older one is not shown
  #request = 0;
  #note = ''; // what is wrong and does not stop anything

  /** `drawing`: see Stage. */
  constructor(workshop, drawing) {
    this.workshop = workshop;
    this.status = new Status(find);
    this.picture = new Picture(find, workshop, drawing, (error) => this.status.fail(error));
    this.controls = new Controls(find, (id, value) => this.change(id, value));
    this.controls.show(this.#settings);
    const { status, controls } = this;
    const [settings, onOpen] = [() => this.#settings, () => this.#leaveMesh()];
    this.maps = new Maps(find, { workshop, stage: this.picture.stage, status, controls, settings, onOpen });
    this.maps.close();
    listen(this, find);
  }

  /** What is downloaded: see offerDownloads(). */
  get download() {
    return { bytes: this.#result.bytes, name: this.#name, file: this.#source.file, options: encodeOptions(this.#settings) };
  }

  change(id, value) {
    this.#settings = changed(this.#settings, id, value);
    this.controls.show(this.#settings);
    this.keepLink();
    if (ENCODING.includes(id)) this.encodeSoon();
    else this.#showPicture();
  }

  keepLink() {
    history.replaceState(null, '', `#${toHash(this.#settings)}`);
  }

  followLink() {
    const before = this.#settings.example;
    this.#settings = fromHash(location.hash);
    this.controls.show(this.#settings);
    this.#showPicture();
    if (this.#settings.example !== before) this.openExample(this.#settings.example);
    else this.encodeSoon();
  }

  /** Ends what is being done; what is shown stays. */
  #stop() {
    clearTimeout(this.#timer);
    ++this.#opening;
    ++this.#request;
    this.status.keepsFailure = false;
    find('still')?.remove(); // of the first example
    this.workshop.cancel();
    this.maps.cancel();
  }

  cancel() {
    this.#stop();
    this.status.tell('Cancelled', false);
  }

  /** One mesh, with the files that it needs. */
  openFiles(files) {
    this.#stop();
    const { file, others, failure } = oneMeshOf(files);
    if (failure) return this.status.fail(failure);
    return this.#open('file', file.name, () => this.workshop.read(file, others), file, others);
  }

  /** A mesh of another place. */
  async openUrl(url) {
    this.#stop();
    this.status.tell(`Fetching ${url}`);
    try {
      await this.openFiles([await fetchFile(url)]);
    } catch (error) {
      this.status.fail(error);
    }
  }

  /** That of the page's address. Where nothing comes of it the example is shown, and still what is wrong. */
  async openFirst(url) {
    await this.openUrl(url);
    if (this.#source || !this.status.hasFailed) return;
    this.status.keepsFailure = true;
    await this.openExample(this.#settings.example, this.workshop.example(this.#settings.example));
  }

  /** The folder of a map; of one that is open the parts that changed. */
  openMap(files) {
    this.#stop();
    return this.maps.openFolder(files);
  }

  /** A map that changes: see Maps. */
  openLive(live, map) {
    this.#stop();
    this.maps.follow(live, map);
  }

  #leaveMesh() {
    clearTimeout(this.#timer); // a slider may have been moved meanwhile
    this.workshop.cancel();
    this.#source = null;
    this.#forgetResult();
    find('example').value = 'file';
  }

  #showPicture() {
    if (this.maps.isOpen) this.maps.show();
    else this.picture.show(this.#settings);
  }

  /** `begun`: what Workshop.example() gave already. */
  openExample(name, begun) {
    const example = (this.#settings.example = exampleOf(name));
    this.keepLink();
    if (!begun) this.#stop();
    return this.#open(example, EXAMPLES[example].label, () => begun ?? this.workshop.example(example));
  }

  /** `example`: what the list of examples says then. `file`, `others`: what is read, where it is no example. */
  async #open(example, name, read, file, others) {
    this.status.tell(`Reading ${name}`);
    const opening = ++this.#opening;
    try {
      const { mesh, frame, display, up, materials, places, prepared, isGlb = false } = await read();
      await nextTask(); // what is read may have been there already
      if (opening !== this.#opening) return;
      find('example').value = example;
      this.maps.close();
      this.#source = { mesh, frame, file: isGlb ? file : null };
      this.#name = name.replace(/\.[^.]*$/, '').toLowerCase();
      this.workshop.setSource(this.#source);
      this.#forgetResult();
      this.picture.setOriginal(display, frame, up);
      this.picture.show(this.#settings);
      this.#note = '';
      await nextTask();
      if (opening !== this.#opening) return;
      if (materials) this.picture.setMaterials(plainMaterials(materials));
      const source = this.#source;
      if (places) await this.#showModel(file, others, { places, count: mesh.positions.length / 3 });
      if (source !== this.#source) return;
      this.controls.showKinds(new Set(mesh.attributes.map(({ kind }) => kind)));
      const [vertices, triangles] = [mesh.positions.length / 3, mesh.indices.length / 3];
      find('mesh-name').textContent = `${name}: ${vertices.toLocaleString('en')} vertices, ${triangles.toLocaleString('en')} triangles`;
      if (prepared && asPrepared(this.#settings)) await this.#showMeasured(prepared);
      else await this.encode();
    } catch (error) {
      this.status.fail(error);
    }
  }

  async #showModel(file, others, about) {
    const source = this.#source;
    try {
      const { missing, ...asset } = await gltfScene(file, others);
      if (source !== this.#source) return;
      this.picture.setModel(asset, about);
      if (missing.length > 0) this.#note = `; choose or drop these, too: ${missing.join(', ')}`;
    } catch (error) {
      if (source === this.#source) this.#note = `; the materials of ${file.name} could not be read: ${error.message}`;
    }
  }

  encodeSoon() {
    clearTimeout(this.#timer);
    ++this.#request;
    this.#timer = setTimeout(() => this.encode(), PAUSE_MILLISECONDS);
  }

  async encode() {
    clearTimeout(this.#timer);
    if (!this.#source) return;
    const [source, request] = [this.#source, this.#request];
    this.status.tell('Compressing');
    try {
      const result = await this.workshop.encode(encodeOptions(this.#settings), (progress) => this.status.follow(progress));
      if (source === this.#source) await this.#showMeasured(result, request);
    } catch (error) {
      this.status.fail(error);
    }
  }

  /** The result at once, then, where nothing else has been asked for since `request`, what is known of it. */
  async #showMeasured(result, request = this.#request) {
    const source = this.#source;
    this.#show(result);
    this.status.tell('Measuring');
    await this.picture.whenSeen();
    if (source !== this.#source || request !== this.#request) return;
    const errors = await this.workshop.errors(result);
    if (source !== this.#source || request !== this.#request) return;
    this.picture.setErrors(errors);
    this.picture.show(this.#settings);
    this.status.tell(`Done${this.#note}`, false);
    this.workshop.prepare();
    await compareWithOthers(find, this.workshop, source, result);
  }

  #show(result) {
    const { bytes } = result;
    this.#result = { bytes };
    this.picture.setResult(result);
    this.picture.show(this.#settings);
    const raw = rawBytes(this.#source.mesh);
    this.picture.setSizes(raw, bytes.length);
    find('headline').textContent = headlineOf(this.#settings.preset, raw, bytes.length);
    showResult(find, result, this.#source, this.#name);
  }

  #forgetResult() {
    this.#result = null;
    this.picture.forgetResult();
    forgetResult(find);
  }
}

