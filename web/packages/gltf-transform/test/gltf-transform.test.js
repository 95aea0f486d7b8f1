// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
import assert from 'node:assert/strict';
import { readdirSync } from 'node:fs';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

import { DeltameshError, createDecoder } from '@deltamesh/decoder';
import { createEncoder } from '@deltamesh/encoder';
import { DeltameshMeshCompression } from '@deltamesh/gltf-transform';
import { Document, Logger, NodeIO } from '@gltf-transform/core';
import validator from 'gltf-validator';

const samples = fileURLToPath(new URL('../../../../gltf_ext/DELTAMESH_mesh_compression/samples/', import.meta.url));

async function makeIO(writes = false) {
  const decoder = await createDecoder();
  await decoder.load();
  return new NodeIO()
    .setLogger(new Logger(Logger.Verbosity.SILENT))
    .registerExtensions([DeltameshMeshCompression])
    .registerDependencies({ 'deltamesh.decoder': decoder, 'deltamesh.encoder': writes ? await createEncoder() : null });
}

const primitivesOf = (document) => document.getRoot().listMeshes().flatMap((mesh) => mesh.listPrimitives());

for (const name of readdirSync(`${samples}valid`)) {
  test(`reads ${name}`, async () => {
    const primitives = primitivesOf(await (await makeIO()).read(`${samples}valid/${name}`));
    assert.ok(primitives.length > 0);
    for (const primitive of primitives) {
      const count = primitive.getAttribute('POSITION').getCount();
      assert.ok(primitive.getIndices().getArray().every((index) => index < count));
    }
  });
}

for (const name of readdirSync(`${samples}invalid`)) {
  test(`refuses ${name} by its rule`, async () => {
    await assert.rejects((await makeIO()).read(`${samples}invalid/${name}`), (error) => {
      assert.ok(error instanceof DeltameshError, String(error));
      assert.equal(error.rule, name.split('_')[0]);
      return true;
    });
  });
}

/** Wavy grids with normals, colours and a morph target, of which the first has texture coordinates, too. */
function makeDocument(size = 12) {
  const document = new Document();
  const buffer = document.createBuffer();
  const column = (type, array) => document.createAccessor().setType(type).setArray(array).setBuffer(buffer);
  const make = (offset) => {
    const rows = [];
    for (let y = 0; y < size; ++y) for (let x = 0; x < size; ++x) rows.push([x + offset, y, Math.sin(x + offset) * Math.cos(y)]);
    const indices = [];
    for (let y = 0; y + 1 < size; ++y)
      for (let x = 0; x + 1 < size; ++x) {
        const v = y * size + x;
        indices.push(v, v + 1, v + size, v + 1, v + size + 1, v + size);
      }
    const target = document.createPrimitiveTarget();
    target.setAttribute('POSITION', column('VEC3', Float32Array.from(rows.flat(), (_, i) => (i % 5) / 8)));
    return document
      .createPrimitive()
      .addTarget(target)
      .setIndices(column('SCALAR', new Uint16Array(indices)))
      .setAttribute('POSITION', column('VEC3', new Float32Array(rows.flat())))
      .setAttribute('NORMAL', column('VEC3', new Float32Array(rows.flatMap(() => [0, 0, 1]))))
      .setAttribute('COLOR_0', column('VEC4', new Uint8Array(rows.flatMap(([x, y]) => [5 * x, 9 * y, 7, 255]))).setNormalized(true));
  };
  const first = make(0);
  const count = first.getAttribute('POSITION').getCount();
  first.setAttribute('TEXCOORD_0', column('VEC2', Float32Array.from({ length: 2 * count }, (_, i) => i / (2 * count))));
  const mesh = document.createMesh().addPrimitive(first).addPrimitive(make(size - 1));
  document.createScene().addChild(document.createNode().setMesh(mesh));
  return document;
}

/** Every corner of every triangle with all its values, in an order that does not depend on the coder's. */
function cornersOf(primitive) {
  const indices = primitive.getIndices().getArray();
  const columns = [...primitive.listSemantics().sort().map((semantic) => primitive.getAttribute(semantic))];
  for (const target of primitive.listTargets()) columns.push(...target.listAttributes());
  const corner = (index) => columns.map((accessor) => accessor.getElement(index, []).join(' ')).join(' | ');
  const faces = [];
  for (let i = 0; i < indices.length; i += 3) {
    const corners = [...indices.slice(i, i + 3)].map(corner);
    const first = corners.indexOf([...corners].sort()[0]);
    faces.push([0, 1, 2].map((k) => corners[(first + k) % 3]).join('\n'));
  }
  return faces.sort();
}

async function roundTrip(document, options) {
  const io = await makeIO(true);
  document.createExtension(DeltameshMeshCompression).setRequired(true).setEncoderOptions(options);
  const glb = await io.writeBinary(document);
  const { json } = await io.binaryToJSON(glb);
  const { issues } = await validator.validateBytes(glb);
  assert.equal(issues.numErrors, 0, JSON.stringify(issues.messages));
  return { json, glb, read: await io.readBinary(glb) };
}

/** Of the first primitive. */
function streamOf({ meshes, bufferViews }, glb) {
  const { byteOffset = 0, byteLength } = bufferViews[meshes[0].primitives[0].extensions.DELTAMESH_mesh_compression.bufferView];
  const binary = 20 + new DataView(glb.buffer, glb.byteOffset).getUint32(12, true) + 8;
  return glb.subarray(binary + byteOffset, binary + byteOffset + byteLength);
}

test('what is written without loss is read again', async () => {
  const document = makeDocument();
  const before = primitivesOf(document).map(cornersOf);
  const { json, read } = await roundTrip(document, { lossless: true });
  assert.deepEqual(primitivesOf(read).map(cornersOf), before);
  assert.deepEqual(json.extensionsRequired, ['DELTAMESH_mesh_compression']);
  const [first, second] = json.meshes[0].primitives;
  assert.equal(first.extensions.DELTAMESH_mesh_compression.bufferView, second.extensions.DELTAMESH_mesh_compression.bufferView);
  assert.equal(second.extensions.DELTAMESH_mesh_compression.group, 1);
  assert.equal(second.attributes.TEXCOORD_0, undefined);
});

test('bounds are kept to', async () => {
  const { read } = await roundTrip(makeDocument(), { maxError: 0.001, normalError: 1, uvError: 0.01, colorError: 2 });
  const [first] = primitivesOf(read);
  const positions = first.getAttribute('POSITION').getArray();
  for (let i = 0; i < positions.length; i += 3) {
    const [x, y, z] = [Math.round(positions[i]), Math.round(positions[i + 1]), positions[i + 2]];
    assert.ok(Math.abs(z - Math.sin(x) * Math.cos(y)) <= 0.001);
  }
});

/** Every option of the encoder, beside those of other tests, and what the stream says of itself then. `size`: its bytes. */
const diagonalOf = ({ box }) => Math.hypot(...box.max.map((value, axis) => value - box.min[axis]));
const codecsOf = ({ chunks }) => new Set(chunks.map(({ codec }) => codec));
const WAYS = [
  [
    { vde: { value: 0.05, unit: 'diagonal' }, lfe: { value: 0.1, unit: 'diagonal' }, effort: 0 },
    (info) => info.quality.vde <= 0.0005 * diagonalOf(info) && info.quality.lfe <= 0.001 * diagonalOf(info),
  ],
  [{ targetBytes: 6000, geometry: 'predictive', effort: 2 }, (info, size) => info.geometry === 'predictive' && size <= 6000],
  [
    { geometry: 'highpass', bits: 6, anchors: 20, anchorBits: 10, profile: 'zstd' },
    (info) => info.geometry === 'highpass' && info.quality.maxError > 0 && !codecsOf(info).has('compact'),
  ],
  [{ geometry: 'highpass', step: 0.01, anchorDensity: 4, keepOrder: true }, (info) => info.geometry === 'highpass' && info.keepsOrder],
  [
    { keepUnreferenced: true, tangentError: 2, weightError: 0.01, attributeErrors: { POSITION: 0.01 } },
    ({ attributes }) => attributes.find(({ name }) => name === 'dPOSITION').error <= 0.01,
  ],
];

for (const [options, holds] of WAYS) {
  test(`options are kept to: ${Object.keys(options).join(', ')}`, async () => {
    const document = makeDocument();
    const counts = primitivesOf(document).map((primitive) => primitive.getIndices().getCount());
    const { json, glb, read } = await roundTrip(document, options);
    assert.ok(json.meshes[0].primitives.every(({ extensions }) => extensions.DELTAMESH_mesh_compression));
    assert.deepEqual(primitivesOf(read).map((primitive) => primitive.getIndices().getCount()), counts);
    const stream = streamOf(json, glb);
    const info = (await createDecoder()).inspect(stream);
    assert.ok(holds(info, stream.length), JSON.stringify({ ...info, size: stream.length }));
  });
}

test('meshes of the same arrays, in other materials, share a stream', async () => {
  const document = makeDocument();
  const [mesh] = document.getRoot().listMeshes();
  const other = document.createMesh();
  for (const primitive of mesh.listPrimitives()) other.addPrimitive(primitive.clone().setMaterial(document.createMaterial()));
  const { json, read } = await roundTrip(document, {});
  const views = json.meshes.flatMap(({ primitives }) => primitives.map(({ extensions }) => extensions.DELTAMESH_mesh_compression.bufferView));
  assert.equal(views.length, 4);
  assert.equal(new Set(views).size, 1);
  const [first, second, third, fourth] = primitivesOf(read).map(cornersOf);
  assert.deepEqual([third, fourth], [first, second]);
});

test('accessors that something else uses, too, stay as they are beside what is packed', async () => {
  const document = makeDocument();
  const [first] = primitivesOf(document);
  const before = first.getAttribute('POSITION').getArray().slice();
  const points = document.createPrimitive().setMode(0).setAttribute('POSITION', first.getAttribute('POSITION'));
  document.createMesh().addPrimitive(points);
  const { json, read } = await roundTrip(document, {});
  assert.ok(json.meshes[0].primitives.every(({ extensions }) => extensions));
  assert.equal(json.meshes[1].primitives[0].extensions, undefined);
  assert.deepEqual(primitivesOf(read)[2].getAttribute('POSITION').getArray(), before);
});

test('where nothing gets smaller the extension is not named; buffers of a document in files become one', async () => {
  const document = new Document();
  const column = (type, array, buffer) => document.createAccessor().setType(type).setArray(array).setBuffer(buffer);
  const buffers = ['a.bin', 'b.bin'].map((uri) => document.createBuffer().setURI(uri));
  const triangle = document
    .createPrimitive()
    .setIndices(column('SCALAR', Uint16Array.of(0, 1, 2), buffers[1]))
    .setAttribute('POSITION', column('VEC3', Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0), buffers[0]));
  document.createScene().addChild(document.createNode().setMesh(document.createMesh().addPrimitive(triangle)));
  document.createExtension(DeltameshMeshCompression).setRequired(true);
  const io = await makeIO(true);
  const written = await io.writeJSON(document);
  assert.equal(written.json.extensionsUsed, undefined);
  assert.deepEqual(Object.keys(written.resources), ['a.bin']);
  const [read] = primitivesOf(await io.readJSON(written));
  assert.deepEqual([...read.getIndices().getArray()], [0, 1, 2]);
  assert.deepEqual([...read.getAttribute('POSITION').getArray()], [0, 0, 0, 1, 0, 0, 0, 1, 0]);
});

test('a request that cannot be met is an error', async () => {
  await assert.rejects(roundTrip(makeDocument(), { targetBytes: 10 }), DeltameshError);
});
