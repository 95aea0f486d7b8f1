// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Files that people open: good ones of every kind, and odd ones.
import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { after, before, test } from 'node:test';

import { makeExample } from '../src/mesh/examples.js';
import { writeGlb } from '../src/mesh/write-glb.js';
import { hasChromium, openPage, waitUntilDone } from './browser.js';
import { boxesOfColors, choose, countColors, drop, dropFiles, textOf } from './use.js';

const skip = hasChromium ? false : 'Chromium is not installed (scripts/setup web)';
const root = new URL('../../../', import.meta.url);

let open;
let page;
before(async () => {
  if (!hasChromium) return;
  open = await openPage({ hash: '#effort=0' });
  ({ page } = open);
  await waitUntilDone(page);
});
after(() => open?.close());

function plyOf({ positions, indices }) {
  const header = `ply\nformat binary_little_endian 1.0\nelement vertex ${positions.length / 3}\nproperty float x\nproperty float y
property float z\nelement face ${indices.length / 3}\nproperty list uchar int vertex_indices\nend_header\n`;
  const faces = Buffer.alloc((indices.length / 3) * 13);
  for (let i = 0, at = 0; i < indices.length; i += 3) {
    at = faces.writeUInt8(3, at);
    for (let c = 0; c < 3; ++c) at = faces.writeInt32LE(indices[i + c], at);
  }
  return Buffer.concat([Buffer.from(header), Buffer.from(positions.buffer), faces]);
}

test('files are opened: PLY, GLB with and without the extension, DMSH', { skip }, async () => {
  const terrain = makeExample('terrain').mesh;
  await drop(page, 'hill.ply', plyOf(terrain));
  assert.match(await textOf(page, 'mesh-name'), /^hill.ply: 32,761 vertices/);
  await drop(page, 'hill.glb', writeGlb(terrain));
  assert.match(await textOf(page, 'mesh-name'), /^hill.glb: 32,761 vertices/);
  assert.match(await textOf(page, 'bytes'), /COLOR_0/);
  const golden = readdirSync(new URL('tests/golden/', root)).find((name) => /^asset\.bounded\..*\.dmsh$/.test(name));
  await drop(page, 'asset.dmsh', readFileSync(new URL(`tests/golden/${golden}`, root)));
  assert.equal(await textOf(page, 'error'), '');
  const samples = new URL('gltf_ext/DELTAMESH_mesh_compression/samples/valid/', root);
  const packed = readdirSync(samples).find((name) => name.endsWith('.glb'));
  await drop(page, packed, readFileSync(new URL(packed, samples)));
  assert.equal(await textOf(page, 'error'), '');
});

const SQUARE = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]];
const CORNERS = [0, 1, 2, 0, 2, 3];

function asciiPly(points, faces) {
  const header = ['ply', 'format ascii 1.0', `element vertex ${points.length}`, 'property float x', 'property float y', 'property float z'];
  if (faces) header.push(`element face ${faces.length}`, 'property list uchar int vertex_indices');
  const rows = [...points.map((point) => point.join(' ')), ...(faces ?? []).map((face) => `3 ${face.join(' ')}`)];
  return Buffer.from([...header, 'end_header', ...rows, ''].join('\n'));
}

function binaryStl() {
  const stl = Buffer.alloc(84 + 50 * 2);
  stl.writeUInt32LE(2, 80);
  CORNERS.forEach((corner, i) => SQUARE[corner].forEach((value, axis) => stl.writeFloatLE(value, 84 + 50 * Math.floor(i / 3) + 12 + 12 * (i % 3) + 4 * axis)));
  return stl;
}

function asciiStl() {
  const triangle = (corners) => `facet normal 0 0 1\nouter loop\n${corners.map((c) => `vertex ${SQUARE[c].join(' ')}`).join('\n')}\nendloop\nendfacet`;
  return Buffer.from(`solid square\n${triangle(CORNERS.slice(0, 3))}\n${triangle(CORNERS.slice(3))}\nendsolid square\n`);
}

const obj = (points) => Buffer.from(`${points.map((point) => `v ${point.join(' ')}`).join('\n')}\nf 1 2 3 4\n`);

/** A .gltf with its buffer in another file, and a texture that nobody has. */
function gltfInFiles() {
  const glb = Buffer.from(writeGlb({ origin: [0, 0, 0], positions: new Float32Array(SQUARE.flat()), indices: new Uint32Array(CORNERS), groups: null, attributes: [] }));
  const size = glb.readUInt32LE(12);
  const json = JSON.parse(glb.toString('utf8', 20, 20 + size));
  json.buffers[0].uri = 'square%20data.bin';
  Object.assign(json, { images: [{ uri: 'nowhere.png' }], textures: [{ source: 0 }], materials: [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 } } }] });
  json.meshes[0].primitives[0].material = 0;
  return [['square.gltf', JSON.stringify(json)], ['square data.bin', glb.subarray(28 + size)]];
}

test('STL of both kinds, OBJ of quads, PLY of text, and glTF in two files are opened', { skip }, async () => {
  const files = { 'b.stl': binaryStl(), 'a.stl': asciiStl(), 'quad.obj': obj(SQUARE), 'a.ply': asciiPly(SQUARE, [CORNERS.slice(0, 3), CORNERS.slice(3)]) };
  for (const [name, bytes] of Object.entries(files)) {
    await drop(page, name, bytes);
    assert.equal(await textOf(page, 'error'), '', name);
    assert.equal(await textOf(page, 'mesh-name'), `${name}: 4 vertices, 2 triangles`);
  }
  await dropFiles(page, gltfInFiles());
  assert.equal(await textOf(page, 'mesh-name'), 'square.gltf: 4 vertices, 2 triangles');
  assert.equal(await textOf(page, 'status'), 'Done; choose or drop these, too: nowhere.png');
});

test('the contents tell what a file is where its name is wrong', { skip }, async () => {
  await drop(page, 'hill.obj', plyOf(makeExample('terrain').mesh));
  assert.match(await textOf(page, 'mesh-name'), /^hill.obj: 32,761 vertices/);
});

/** A GLB whose buffer is somewhere else. */
function glbOfElsewhere() {
  const glb = Buffer.from(writeGlb({ origin: [0, 0, 0], positions: new Float32Array(SQUARE.flat()), indices: new Uint32Array(CORNERS), groups: null, attributes: [] }));
  const json = JSON.parse(glb.toString('utf8', 20, 20 + glb.readUInt32LE(12)));
  json.buffers[0].uri = 'http://localhost:9/far.bin';
  const text = JSON.stringify(json);
  const chunk = Buffer.from(text.padEnd(Math.ceil(text.length / 4) * 4));
  const header = Buffer.alloc(20);
  header.write('glTF');
  header.writeUInt32LE(2, 4);
  header.writeUInt32LE(20 + chunk.length, 8);
  header.writeUInt32LE(chunk.length, 12);
  header.write('JSON', 16);
  return Buffer.concat([header, chunk]);
}

/** Files that cannot be opened, with what is said. */
const ODD = [
  [/^letter.txt is none of PLY, OBJ/, ['letter.txt', 'hello']],
  [/^empty.ply is empty$/, ['empty.ply', '']],
  [/letter.glb cannot be opened as GLB: it is neither a GLB file nor JSON/, ['letter.glb', 'hello, this is a letter']],
  [/cut.glb cannot be opened as GLB: it is cut off, damaged or too large/, ['cut.glb', writeGlb(makeExample('knot').mesh).subarray(0, 1000)]],
  [/far.glb cannot be opened as GLB: it needs http:\/\/localhost:9\/far.bin, which is not a part of it/, ['far.glb', glbOfElsewhere()]],
  [/old.gltf cannot be opened as GLTF: .*versions >=2.0/, ['old.gltf', '{"asset":{"version":"1.0"}}']],
  [/square.gltf cannot be opened as GLTF: its buffer square data.bin is a file of its own/, gltfInFiles()[0]],
  [/letter.ply cannot be opened as PLY: its header has no end/, ['letter.ply', 'hello, this is a letter']],
  [/cut.ply cannot be opened as PLY: it is cut off, damaged or too large/, ['cut.ply', plyOf(makeExample('knot').mesh).subarray(0, 1000)]],
  [/cloud.ply cannot be opened as PLY: it has no faces/, ['cloud.ply', asciiPly(SQUARE)]],
  [/no faces.ply cannot be opened as PLY: it has no faces/, ['no faces.ply', asciiPly(SQUARE, [])]],
  [/wild.ply cannot be opened as PLY: a face has a vertex that is none of its 4/, ['wild.ply', asciiPly(SQUARE, [[0, 1, 9]])]],
  [/minus.ply cannot be opened as PLY: a face has a vertex/, ['minus.ply', asciiPly(SQUARE, [[0, 1, -1]])]],
  [/nan.obj cannot be opened as OBJ: a coordinate is not a finite number/, ['nan.obj', obj([['nan', 0, 0], ...SQUARE.slice(1)])]],
  [/huge.obj cannot be opened as OBJ: a coordinate is not a finite number/, ['huge.obj', obj([['1e300', 0, 0], ...SQUARE.slice(1)])]],
  [/points.obj cannot be opened as OBJ: it has no triangles/, ['points.obj', 'v 0 0 0\nv 1 0 0\n']],
  [/letter.obj cannot be opened as OBJ: it has no triangles/, ['letter.obj', 'hello, this is a letter']],
  [/letter.stl cannot be opened as STL: ./, ['letter.stl', 'hello, this is a letter']],
  [/cut.stl cannot be opened as STL: it is cut off, damaged or too large/, ['cut.stl', binaryStl().subarray(0, 120)]],
  [/broken.dmsh cannot be opened as DMSH: .*\[/, ['broken.dmsh', 'DMSHDMSHDMSHDMSH']],
  [/^Open one mesh at a time: a.stl, b.stl/, ['a.stl', asciiStl()], ['b.stl', binaryStl()]],
  [/^None of these is a mesh: a.bin, b.bin/, ['a.bin', 'a'], ['b.bin', 'b']],
];

test('what cannot be opened is said, and the page goes on', { skip }, async (t) => {
  for (const [expected, ...files] of ODD) {
    await dropFiles(page, files);
    const said = await textOf(page, 'error');
    t.diagnostic(said);
    assert.equal(await page.$eval('#error', (error) => error.hidden), false, String(expected));
    assert.match(said, expected);
  }
  await page.select('#example', 'terrain');
  await page.waitForFunction(() => document.getElementById('mesh-name').textContent.startsWith('Terrain'));
  await waitUntilDone(page);
  assert.equal(await page.$eval('#error', (error) => error.hidden), true);
  assert.ok((await countColors(page)) > 50);
});

test('what was dropped last is shown, whatever was being read', { skip }, async () => {
  await page.evaluate((ply, stl) => {
    const decode = (base64) => Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
    document.body.dataset.state = 'busy';
    for (const [name, base64] of [['first.ply', ply], ['last.stl', stl]]) {
      const dataTransfer = new DataTransfer();
      dataTransfer.items.add(new File([decode(base64)], name));
      document.body.dispatchEvent(new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true }));
    }
  }, plyOf(makeExample('knot').mesh).toString('base64'), binaryStl().toString('base64'));
  await page.waitForFunction(() => document.getElementById('mesh-name').textContent.startsWith('last.stl'));
  await waitUntilDone(page);
  assert.equal(await textOf(page, 'error'), '');
});

test('what is being done can be cancelled', { skip }, async () => {
  await page.$eval('input[name="effort"][value="2"]', (input) => input.click());
  const status = await page.evaluate(async () => {
    const [status, cancel, example] = ['status', 'cancel', 'example'].map((id) => document.getElementById(id));
    const begun = new Promise((resolve) => {
      new MutationObserver(() => status.textContent.startsWith('Compressing') && resolve()).observe(status, { childList: true });
    });
    example.value = 'knot';
    example.dispatchEvent(new Event('change'));
    await begun;
    cancel.click();
    return status.textContent;
  });
  assert.equal(status, 'Cancelled');
  assert.equal(await page.$eval('#cancel', (button) => button.hidden), true);
  await page.$eval('input[name="effort"][value="0"]', (input) => input.click());
  await page.waitForFunction(() => document.getElementById('status').textContent === 'Done');
});

/** A triangle that stands on its side where y is up, of two materials. */
function gltfWithMaterials() {
  const positions = Buffer.from(new Float32Array([0, 0, 0, 1, 0, 0, 0, 3, 0]).buffer);
  const primitive = (material) => ({ attributes: { POSITION: 0 }, material });
  const color = (baseColorFactor) => ({ pbrMetallicRoughness: { baseColorFactor }, doubleSided: true });
  return Buffer.from(JSON.stringify({
    asset: { version: '2.0' }, scene: 0, scenes: [{ nodes: [0, 1] }],
    nodes: [{ mesh: 0 }, { mesh: 1, translation: [1.5, 0, 0] }],
    meshes: [{ primitives: [primitive(0)] }, { primitives: [primitive(1)] }],
    materials: [color([1, 0, 0, 1]), color([0, 0, 1, 1])],
    accessors: [{ bufferView: 0, componentType: 5126, count: 3, type: 'VEC3', min: [0, 0, 0], max: [1, 3, 0] }],
    bufferViews: [{ buffer: 0, byteLength: 36 }],
    buffers: [{ byteLength: 36, uri: `data:application/octet-stream;base64,${positions.toString('base64')}` }],
  }));
}

test('glTF is seen in its materials, y up, and otherwise by choice', { skip }, async () => {
  await drop(page, 'two.gltf', gltfWithMaterials());
  assert.equal(await textOf(page, 'error'), '');
  await choose(page, 'view', 'original');
  const extents = async () => boxesOfColors(page);
  const { red, blue } = await extents();
  assert.ok(red.count > 200 && blue.count > 200, JSON.stringify({ red, blue }));
  assert.ok(red.height > red.width, 'it stands');
  await choose(page, 'up', 'z');
  const lying = (await extents()).red;
  assert.ok(lying.height < red.height, 'it lies');
  await choose(page, 'up', 'file');
  await choose(page, 'view', 'split');
});

test('nothing went wrong on the console but what OBJLoader tells of a letter', { skip }, () => {
  assert.deepEqual(open.problems.filter((problem) => !problem.startsWith('THREE.OBJLoader: Unexpected line')), []);
});
