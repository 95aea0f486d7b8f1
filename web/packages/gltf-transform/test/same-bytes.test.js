// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The same asset packed by the program and by the module is the same file, and packed by glTF-Transform it has the same streams.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

import { DeltameshError, createDecoder } from '@deltamesh/decoder';
import { createEncoder } from '@deltamesh/encoder';
import { DeltameshMeshCompression } from '@deltamesh/gltf-transform';
import { Document, Logger, NodeIO } from '@gltf-transform/core';
import { ALL_EXTENSIONS, EXTMeshGPUInstancing, KHRTextureTransform } from '@gltf-transform/extensions';

const root = fileURLToPath(new URL('../../../../', import.meta.url));
const PROGRAM = join(root, 'build/release/deltamesh');
const CORPUS = process.env.DELTAMESH_CORPUS ?? join(root, '../shared/corpus');
const NAME = 'DELTAMESH_mesh_compression';
const STRIP = 5;
const FAN = 6;

/** A wavy grid at `offset`; `twice`: with a second copy of its first row of vertices and a triangle that draws nothing;
 * `flat`: without indices; `path`: the mode of what has its first indices; `quantised`: positions in sixteen bits; `stretch`: of a texture. */
function addGrid(document, mesh, { size = 24, offset = 0, targets = 0, uvs = false, twice = false, flat = false, path, quantised, stretch }) {
  const buffer = document.getRoot().listBuffers()[0] ?? document.createBuffer();
  const column = (type, array) => document.createAccessor().setType(type).setArray(array).setBuffer(buffer);
  let rows = [];
  for (let y = 0; y < size; ++y) for (let x = 0; x < size; ++x) rows.push([x + offset, y, Math.sin((x + offset) / 3) * Math.cos(y / 4)]);
  const indices = [];
  for (let y = 0; y + 1 < size; ++y)
    for (let x = 0; x + 1 < size; ++x) {
      const v = y * size + x;
      indices.push(v, v + 1, v + size, v + 1, v + size + 1, v + size);
    }
  if (twice) {
    for (let x = 0; x < size; ++x) rows.push(rows[x]);
    for (let i = 0; i < 30; ++i) if (indices[i] < size) indices[i] += size * size;
    indices.push(0, 0, 5);
  }
  if (flat) rows = indices.map((index) => rows[index]);
  const normals = rows.map(([x, y]) => {
    const [nx, ny] = [-Math.cos(x / 3) * Math.cos(y / 4) / 3, Math.sin(x / 3) * Math.sin(y / 4) / 4];
    return [nx, ny, 1].map((k) => k / Math.hypot(nx, ny, 1));
  });
  const primitive = document
    .createPrimitive()
    .setIndices(flat ? null : column('SCALAR', new Uint16Array(indices)))
    .setAttribute('POSITION', column('VEC3', new Float32Array(rows.flat())))
    .setAttribute('NORMAL', column('VEC3', new Float32Array(normals.flat())))
    .setAttribute('_HEAT', column('SCALAR', new Float32Array(rows.map(([x]) => x / 7))));
  if (uvs) primitive.setAttribute('TEXCOORD_0', column('VEC2', new Float32Array(rows.flatMap(([x, y]) => [x / 50, y / 50]))));
  for (let t = 1; t <= targets; ++t) {
    const moved = new Float32Array(rows.flatMap(([x, y]) => [0, 0, Math.exp(-((x - 4 * t) ** 2 + (y - 9) ** 2) / 20)]));
    const turned = new Float32Array(rows.flatMap(([x, y]) => [Math.sin(x / (3 + t)) / 9, Math.cos(y / 5) / 9, 0]));
    primitive.addTarget(document.createPrimitiveTarget().setAttribute('POSITION', column('VEC3', moved)).setAttribute('NORMAL', column('VEC3', turned)));
  }
  if (path) primitive.setMode(path).getIndices().setArray(new Uint16Array(indices.slice(0, 200)));
  if (quantised) primitive.getAttribute('POSITION').setArray(new Int16Array(rows.flat().map((x) => x * 500)));
  if (stretch) {
    const material = document.createMaterial().setBaseColorTexture(document.createTexture().setImage(PIXEL).setMimeType('image/png'));
    const transform = document.createExtension(KHRTextureTransform).createTransform().setScale([stretch, 1]);
    material.getBaseColorTextureInfo().setExtension(KHRTextureTransform.EXTENSION_NAME, transform);
    primitive.setMaterial(material);
  }
  mesh.addPrimitive(primitive);
}

const PIXEL = Buffer.from('iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M9QDwADhgGAWjR9awAAAABJRU5ErkJggg==', 'base64');

/** `step`: how far apart the meshes' nodes are. `instances`: of every mesh. */
function makeDocument(meshes, { step = 100, instances = 0 } = {}) {
  const document = new Document();
  const scene = document.createScene();
  for (const primitives of meshes) {
    const mesh = document.createMesh();
    for (const primitive of primitives) addGrid(document, mesh, primitive);
    const node = document.createNode().setMesh(mesh).setTranslation([scene.listChildren().length * step, 0, 0]);
    if (instances > 0) {
      const places = document.createAccessor().setType('VEC3').setBuffer(document.getRoot().listBuffers()[0]);
      places.setArray(Float32Array.from({ length: 3 * instances }, (_, i) => 7 * i));
      const placed = document.createExtension(EXTMeshGPUInstancing).createInstancedMesh().setAttribute('TRANSLATION', places);
      node.setExtension(EXTMeshGPUInstancing.EXTENSION_NAME, placed);
    }
    scene.addChild(node);
  }
  return document;
}

/** The stream of every primitive. */
function streamsOf(glb) {
  const size = new DataView(glb.buffer, glb.byteOffset).getUint32(12, true);
  const { meshes, bufferViews } = JSON.parse(new TextDecoder().decode(glb.subarray(20, 20 + size)));
  return meshes.flatMap(({ primitives }) =>
    primitives.map(({ extensions }) => {
      if (!extensions?.[NAME]) return null;
      const { byteOffset = 0, byteLength } = bufferViews[extensions[NAME].bufferView];
      return Buffer.from(glb.subarray(28 + size + byteOffset, 28 + size + byteOffset + byteLength));
    }),
  );
}

const ASSETS = {
  'morph targets': [[[{ targets: 3 }]]],
  'several primitives, of which one has texture coordinates': [[[{ uvs: true }, { offset: 23 }, { offset: 46, twice: true }]]],
  'no indices': [[[{ flat: true, uvs: true }]]],
  'equal meshes': [[[{ uvs: true, targets: 1 }], [{ size: 9, offset: 300 }], [{ uvs: true, targets: 1 }]]],
  'meshes with a border in common': [[[{}], [{ offset: 23 }], [{ offset: 46, uvs: true }]], { step: 0 }],
  'positions of integers, a strip and a fan': [[[{ quantised: true }], [{ path: STRIP }, { path: FAN, offset: 70 }]]],
  'a stretched texture, and instances': [[[{ uvs: true, stretch: 5 }]], { instances: 9 }],
};
const WAYS = [
  [[], {}],
  [['--max-error', '0.01', '--normal-error', '2', '--attribute-error', 'POSITION=0.002'], { maxError: 0.01, normalError: 2, attributeErrors: { POSITION: 0.002 } }],
  [['--vde', '0.1%', '--effort', '0'], { vde: { value: 0.1, unit: 'diagonal' }, effort: 0 }],
  [['--lossless'], { lossless: true }],
  [['--fallback', '--keep-order'], { fallback: true, keepOrder: true }],
];

async function makeIO() {
  const decoder = await createDecoder();
  await decoder.load();
  return new NodeIO()
    .setLogger(new Logger(Logger.Verbosity.SILENT))
    .registerExtensions([...ALL_EXTENSIONS, DeltameshMeshCompression])
    .registerDependencies({ 'deltamesh.decoder': decoder, 'deltamesh.encoder': await createEncoder() });
}

function packedByProgram(glb, options) {
  const folder = mkdtempSync(join(tmpdir(), 'deltamesh-'));
  try {
    writeFileSync(join(folder, 'plain.glb'), glb);
    execFileSync(PROGRAM, ['gltf', 'pack', 'plain.glb', 'packed.glb', ...options], { cwd: folder, stdio: 'ignore' });
    return readFileSync(join(folder, 'packed.glb'));
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/** `document`: by glTF-Transform. */
async function checkSame(document, options, same) {
  const io = await makeIO();
  const plain = await io.writeBinary(document);
  const theirs = packedByProgram(plain, options);
  const packed = (await createEncoder()).packGltf(plain, same);
  assert.ok(!(packed instanceof DeltameshError), packed.message);
  assert.ok(theirs.equals(packed.bytes), 'the files differ');
  assert.deepEqual([packed.report.inputBytes, packed.report.outputBytes], [plain.length, theirs.length]);
  document.createExtension(DeltameshMeshCompression).setEncoderOptions(same);
  const ours = await io.writeBinary(document);
  const streams = streamsOf(ours);
  assert.deepEqual(streams.map((stream) => stream?.length), streamsOf(theirs).map((stream) => stream?.length));
  streamsOf(theirs).forEach((stream, i) => assert.ok(stream === streams[i] || stream.equals(streams[i]), `primitive ${i} differs`));
  const { converted } = packed.report;
  assert.equal(converted, streams.filter(Boolean).length);
  return { report: packed.report, ours };
}

const skip = !existsSync(PROGRAM) && 'the program is not built';
for (const [name, asset] of Object.entries(ASSETS)) {
  for (const [options, same] of WAYS) {
    test(`${name}, ${options.join(' ') || 'no options'}`, { skip }, async () => {
      const { report, ours } = await checkSame(makeDocument(...asset), options, same);
      assert.equal(report.converted, report.primitives);
      const read = await (await makeIO()).readBinary(ours);
      const instanced = read.getRoot().listNodes().map((node) => node.getExtension(EXTMeshGPUInstancing.EXTENSION_NAME)).filter(Boolean);
      for (const places of instanced) assert.deepEqual(places.getAttribute('TRANSLATION').getElement(1, []), [21, 28, 35]);
    });
  }
}

/** Of the corpus, where that is. */
const FILES = ['gltf', 'formats'].flatMap((folder) =>
  existsSync(join(CORPUS, folder)) ? readdirSync(join(CORPUS, folder)).filter((file) => /\.(glb|gltf)$/.test(file)).map((file) => join(CORPUS, folder, file)) : [],
);
for (const file of FILES) {
  for (const [options, same] of WAYS) {
    test(`${file.split('/').at(-1)}, ${options.join(' ') || 'no options'}`, { skip }, async () => {
      const document = await (await makeIO()).setStrictResources(false).read(file); // images may not be there
      await checkSame(document, options, same);
    });
  }
}

test('what is no asset, or has buffers elsewhere, is an error with a place', async () => {
  const encoder = await createEncoder();
  const text = (json) => new TextEncoder().encode(json);
  const asset = { asset: { version: '2.0' }, buffers: [{ byteLength: 4, uri: 'elsewhere.bin' }] };
  assert.match(encoder.packGltf(text('nothing')).message, /neither a GLB/);
  assert.match(encoder.packGltf(text('{"asset": {"version": 2.0,}}')).message, /not valid JSON, byte 27/);
  assert.match(encoder.packGltf(text('{"asset": 1e999}')).message, /too large/);
  assert.match(encoder.packGltf(text(JSON.stringify(asset))).message, /cannot be reached/);
  assert.match(encoder.packGltf(text('{}'), { effort: 7 }).message, /effort/);
});
