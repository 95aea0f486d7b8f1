// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// The page: settings in, streams and pictures out.
import { Superseded } from './latest-job.js';
import { mapOf } from './map/map-files.js';
import { MapView } from './map/map-view.js';
import { EXAMPLES } from './mesh/examples.js';
import { isMeshName } from './mesh/mesh-names.js';
import { Controls } from './panel/controls.js';
import { makeDivider } from './panel/divider.js';
import { download, openFiles } from './panel/open.js';
import { showBytes, showErrors, showPeers } from './panel/report.js';
import { requestOf } from './peers/request.js';
import { Picture } from './picture.js';
import { ENCODING, encodeOptions, fromHash, toHash } from './settings.js';
import { formatBytes, formatNumber } from './units.js';
import { Workshop } from './workshop.js';

/** A slider on the move does not start work at each step. */
const PAUSE_MILLISECONDS = 200;

const find = (id) => document.getElementById(id);

class Page {
  #settings = fromHash(location.hash);
  #source = null;
  #result = null;
  #name = '';
  #timer = 0;

  constructor(workshop) {
    this.workshop = workshop;
    this.picture = new Picture(find, workshop);
    this.map = new MapView(find, workshop.map, this.picture.stage);
    this.controls = new Controls({ quality: find('quality'), coder: find('coder'), view: find('view') }, (id, value) =>
      this.change(id, value),
    );
    this.controls.show(this.#settings);
    this.#showMapPanel(false);
    for (const [name, { label }] of Object.entries(EXAMPLES)) find('example').add(new Option(label, name));
    find('example').add(new Option('Own file', 'file'));
    find('example').options[2].hidden = true;
    find('example').addEventListener('change', ({ target }) => this.openExample(target.value));
    openFiles({ input: find('file'), folderInput: find('folder'), hint: find('drop-hint') }, {
      onFiles: (files) => this.openFiles(files),
      onFolder: (files) => this.openMap(files),
      onFailure: (error) => this.#fail(error),
    });
    makeDivider(find('divider'), (share) => this.picture.setSplit(share));
    find('panel').addEventListener('submit', (event) => event.preventDefault());
    find('cancel').addEventListener('click', () => this.cancel());
    find('download-glb').addEventListener('click', () => this.downloadGlb());
    find('copy-link').addEventListener('click', () => this.copyLink());
    window.addEventListener('hashchange', () => this.followLink());
  }

  change(id, value) {
    this.#settings[id] = value;
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

  async copyLink() {
    this.keepLink();
    try {
      await navigator.clipboard.writeText(location.href);
      find('status').textContent = 'The link is in the clipboard';
    } catch {
      find('status').textContent = 'The link is in the address bar';
    }
  }

  /** Ends what is being done; what is shown stays. */
  #stop() {
    clearTimeout(this.#timer);
    this.workshop.cancel();
    this.map.cancel();
  }

  cancel() {
    this.#stop();
    this.#tell('Cancelled', false);
  }

  /** One mesh, with the files that it needs. */
  openFiles(files) {
    const meshes = files.length === 1 ? files : files.filter(({ name }) => isMeshName(name));
    if (meshes.length !== 1) {
      this.#stop();
      const names = files.map(({ name }) => name).join(', ');
      this.#fail(new Error(`${meshes.length === 0 ? 'None of these is a mesh' : 'Open one mesh at a time'}: ${names}`));
      return undefined;
    }
    const [file] = meshes;
    return this.#open('file', file.name, () => this.workshop.read(file, files.filter((other) => other !== file)));
  }

  /** The folder of a map; of one that is open the parts that changed. */
  async openMap(files) {
    this.#stop();
    this.#tell('Reading the map');
    try {
      const map = mapOf(files);
      if (!map) throw new Error('this folder has no map: there is no map.dmm');
      await this.map.open(map, (share) => (find('progress').value = share));
      clearTimeout(this.#timer); // a slider may have been moved meanwhile
      this.workshop.cancel();
      this.#source = null;
      this.#forgetResult();
      this.#showMapPanel(true);
      find('example').value = 'file';
      this.#showPicture();
      const { title, summary } = this.map.describe();
      find('mesh-name').textContent = `Map: ${title}`;
      find('summary').textContent = summary;
      this.#tell('Done', false);
    } catch (error) {
      this.#fail(error);
    }
  }

  /** For scripts that follow a map: the part `place` from other bytes. */
  async replacePart(place, bytes) {
    await this.map.replace(place, bytes);
    this.#showPicture();
  }

  #showMapPanel(isMap) {
    for (const id of ['quality', 'coder', 'others']) find(id).hidden = isMap;
    find('copy-link').hidden = isMap;
    for (const id of ['label-original', 'label-result', 'divider']) if (isMap) find(id).hidden = true;
    this.controls.showMap(isMap);
  }

  #showPicture() {
    if (this.map.isOpen) this.map.show(this.#settings);
    else this.picture.show(this.#settings);
  }

  openExample(name) {
    this.#settings.example = Object.hasOwn(EXAMPLES, name) ? name : 'knot';
    this.keepLink();
    return this.#open(this.#settings.example, EXAMPLES[this.#settings.example].label, () => this.workshop.example(this.#settings.example));
  }

  /** `example`: what the list of examples says then. */
  async #open(example, name, read) {
    this.#stop();
    this.#tell(`Reading ${name}`);
    try {
      const { mesh, frame, display } = await read();
      find('example').value = example;
      this.map.close();
      this.#showMapPanel(false);
      this.#source = { mesh, frame };
      this.#name = name.replace(/\.[^.]*$/, '').toLowerCase();
      this.workshop.setSource(this.#source);
      this.#forgetResult();
      this.picture.setOriginal(display, frame);
      this.picture.show(this.#settings);
      this.controls.showKinds(new Set(mesh.attributes.map(({ kind }) => kind)));
      const [vertices, triangles] = [mesh.positions.length / 3, mesh.indices.length / 3];
      find('mesh-name').textContent =
        `${name}: ${vertices.toLocaleString('en')} vertices, ${triangles.toLocaleString('en')} triangles`;
      await this.encode();
    } catch (error) {
      this.#fail(error);
    }
  }

  encodeSoon() {
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => this.encode(), PAUSE_MILLISECONDS);
  }

  async encode() {
    if (!this.#source) return;
    clearTimeout(this.#timer);
    const source = this.#source;
    this.#tell('Compressing');
    try {
      const result = await this.workshop.encode(encodeOptions(this.#settings), ({ step, share }) => {
        find('progress').value = share;
        if (find('status').textContent !== step) find('status').textContent = step; // it is read out
      });
      if (source !== this.#source) return;
      this.#show(result);
      await this.#compareWithOthers(result);
    } catch (error) {
      this.#fail(error);
    }
  }

  #show(result) {
    const { bytes, info, display, errors } = result;
    this.#result = { bytes };
    this.picture.setResult(display, errors);
    this.picture.show(this.#settings);
    const { mesh, frame } = this.#source;
    const raw = mesh.positions.byteLength + mesh.indices.byteLength + mesh.attributes.reduce((sum, a) => sum + a.values.byteLength, 0);
    this.picture.setSizes(raw, bytes.length);
    showBytes(find('bytes'), info, bytes.length);
    showErrors(find('errors'), info, frame.diagonal);
    const bits = formatNumber((8 * bytes.length) / info.vertexCount);
    find('summary').textContent =
      `${formatBytes(bytes.length)}, ${bits} bits per vertex, ${info.geometry}; ` +
      `compressed in ${formatNumber(info.encodeMilliseconds / 1000)} s, decoded in ${formatNumber(info.decodeMilliseconds)} ms`;
    const link = find('download');
    if (link.href) URL.revokeObjectURL(link.href);
    link.href = URL.createObjectURL(new Blob([bytes], { type: 'application/octet-stream' }));
    link.download = `${this.#name}.dmsh`;
    link.hidden = find('download-glb').hidden = false;
    this.#tell('Done', false);
  }

  async #compareWithOthers({ bytes, info }) {
    const isExact = !(info.quality.maxError > 0);
    find('peers-status').textContent = isExact ? 'The result is exact: there is no error to compare at.' : 'Computing';
    find('peers').replaceChildren(); // those of an earlier result
    if (isExact) return;
    try {
      const request = requestOf(this.#source.mesh, info, bytes.length);
      showPeers(find('peers'), request, await this.workshop.compare(request));
      find('peers-status').textContent = `${request.names.join(', ')}.`;
    } catch (error) {
      if (!(error instanceof Superseded)) find('peers-status').textContent = `This could not be computed: ${error.message}`;
    }
  }

  async downloadGlb() {
    try {
      download(await this.workshop.glb(this.#result.bytes), `${this.#name}.glb`, 'model/gltf-binary');
    } catch (error) {
      this.#fail(error);
    }
  }

  #forgetResult() {
    this.#result = null;
    this.picture.forgetResult();
    for (const id of ['bytes', 'errors', 'peers']) find(id).replaceChildren();
    find('summary').textContent = '';
    find('download').hidden = find('download-glb').hidden = true;
  }

  #tell(text, isBusy = true) {
    find('status').textContent = text;
    find('error').textContent = '';
    find('error').hidden = true;
    find('progress').style.visibility = isBusy ? 'visible' : 'hidden';
    if (!isBusy && document.activeElement === find('cancel')) find('canvas').focus(); // what is hidden loses it
    find('cancel').hidden = !isBusy;
    find('progress').value = 0;
    document.body.dataset.state = isBusy ? 'busy' : 'done';
  }

  #fail(error) {
    if (error instanceof Superseded) return;
    this.#tell('', false);
    document.body.dataset.state = 'failed';
    find('error').textContent = error.message;
    find('error').hidden = false;
  }
}

const page = new Page(await Workshop.open());
window.viewer = { replacePart: (place, bytes) => page.replacePart(place, bytes) };
page.openExample(fromHash(location.hash).example);
