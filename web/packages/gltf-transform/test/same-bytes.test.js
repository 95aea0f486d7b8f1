// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The same asset packed by the program and by glTF-Transform has the same streams.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

import { createDecoder } from '@deltamesh/decoder';
import { createEncoder } from '@deltamesh/encoder';
import { DeltameshMeshCompression } from '@deltamesh/gltf-transform';
import { Document, Logger, NodeIO } from '@gltf-transform/core';

const PROGRAM = fileURLToPath(new URL('../../../../build/release/deltamesh', import.meta.url));
const NAME = 'DELTAMESH_mesh_compression';

/** A wavy grid at `offset`; `twice`: with a second copy of its first row of vertices and a triangle that draws nothing;
 * `flat`: without indices. */
function addGrid(document, mesh, { size = 24, offset = 0, targets = 0, uvs = false, twice = false, flat = false }) {
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
  mesh.addPrimitive(primitive);
}

function makeDocument(meshes) {
  const document = new Document();
  const scene = document.createScene();
  for (const primitives of meshes) {
    const mesh = document.createMesh();
    for (const primitive of primitives) addGrid(document, mesh, primitive);
    scene.addChild(document.createNode().setMesh(mesh).setTranslation([scene.listChildren().length * 100, 0, 0]));
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
  'morph targets': [[{ targets: 3 }]],
  'several primitives, of which one has texture coordinates': [[{ uvs: true }, { offset: 23 }, { offset: 46, twice: true }]],
  'no indices': [[{ flat: true, uvs: true }]],
  'equal meshes': [[{ uvs: true, targets: 1 }], [{ size: 9, offset: 300 }], [{ uvs: true, targets: 1 }]],
};
const WAYS = [
  [[], {}],
  [['--max-error', '0.01', '--normal-error', '2', '--attribute-error', 'POSITION=0.002'], { maxError: 0.01, normalError: 2, attributeErrors: { POSITION: 0.002 } }],
  [['--vde', '0.1%', '--effort', '0'], { vde: { value: 0.1, unit: 'diagonal' }, effort: 0 }],
  [['--lossless'], { lossless: true }],
];

for (const [name, meshes] of Object.entries(ASSETS)) {
  for (const [options, same] of WAYS) {
    test(`${name}, ${options.join(' ') || 'no options'}`, { skip: !existsSync(PROGRAM) && 'the program is not built' }, async () => {
      const folder = mkdtempSync(join(tmpdir(), 'deltamesh-'));
      try {
        const plain = await new NodeIO().setLogger(new Logger(Logger.Verbosity.SILENT)).writeBinary(makeDocument(meshes));
        writeFileSync(join(folder, 'plain.glb'), plain);
        execFileSync(PROGRAM, ['gltf', 'pack', 'plain.glb', 'packed.glb', ...options], { cwd: folder, stdio: 'ignore' });
        const decoder = await createDecoder();
        await decoder.load();
        const io = new NodeIO()
          .registerExtensions([DeltameshMeshCompression])
          .registerDependencies({ 'deltamesh.decoder': decoder, 'deltamesh.encoder': await createEncoder() });
        const document = await io.readBinary(plain);
        document.createExtension(DeltameshMeshCompression).setRequired(true).setEncoderOptions(same);
        const ours = streamsOf(await io.writeBinary(document));
        const theirs = streamsOf(readFileSync(join(folder, 'packed.glb')));
        assert.deepEqual(ours.map((stream) => stream?.length), theirs.map((stream) => stream?.length));
        ours.forEach((stream, i) => assert.ok(stream === theirs[i] || stream.equals(theirs[i]), `primitive ${i} differs`));
      } finally {
        rmSync(folder, { recursive: true });
      }
    });
  }
}
