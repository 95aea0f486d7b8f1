// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Assets as scenes: animations move the original and the result alike; what Draco and meshoptimizer compressed is opened.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';

import { Document, NodeIO } from '@gltf-transform/core';
import { EXTMeshoptCompression, KHRDracoMeshCompression } from '@gltf-transform/extensions';
import createDracoDecoder from 'draco3d/draco_decoder_nodejs.js';
import createDracoEncoder from 'draco3d/draco_encoder_nodejs.js';
import { MeshoptEncoder } from 'meshoptimizer/encoder';

import { makeExample } from '../src/mesh/examples.js';
import { hasChromium, openPage, waitUntilDone } from './browser.js';
import { choose, drop, picture, textOf } from './use.js';

const skip = hasChromium ? false : 'Chromium is not installed (scripts/setup web)';

let open;
before(async () => {
  if (!hasChromium) return;
  open = await openPage({ hash: '#example=terrain&effort=0' });
  await waitUntilDone(open.page);
});
after(() => open?.close());

/** A hill that moves to the side in one second. */
function movingHill() {
  const { positions, indices } = makeExample('terrain').mesh;
  const document = new Document();
  const buffer = document.createBuffer();
  const accessor = (type, array) => document.createAccessor().setType(type).setArray(array).setBuffer(buffer);
  const primitive = document.createPrimitive().setAttribute('POSITION', accessor('VEC3', positions)).setIndices(accessor('SCALAR', indices));
  const node = document.createNode().setMesh(document.createMesh().addPrimitive(primitive));
  document.createScene().addChild(node);
  const sampler = document.createAnimationSampler().setInput(accessor('SCALAR', new Float32Array([0, 1]))).setOutput(accessor('VEC3', new Float32Array([0, 0, 0, 500, 0, 0])));
  const channel = document.createAnimationChannel().setTargetNode(node).setTargetPath('translation').setSampler(sampler);
  document.createAnimation('away').addSampler(sampler).addChannel(channel);
  return document;
}

async function bytesOf(document, extension) {
  const [encoder, decoder] = await Promise.all([createDracoEncoder(), createDracoDecoder(), MeshoptEncoder.ready]);
  const io = new NodeIO()
    .registerExtensions([EXTMeshoptCompression, KHRDracoMeshCompression])
    .registerDependencies({ 'draco3d.encoder': encoder, 'draco3d.decoder': decoder, 'meshopt.encoder': MeshoptEncoder });
  if (extension) document.createExtension(extension).setRequired(true);
  return io.writeBinary(document);
}

function goTo(page, place) {
  return page.$eval('#time', (slider, place) => {
    slider.value = place;
    slider.dispatchEvent(new Event('input'));
  }, place);
}

test('an animation is shown at the time that is chosen, on both sides alike', { skip }, async () => {
  const { page } = open;
  await drop(page, 'moving.glb', await bytesOf(movingHill()));
  assert.equal(await page.$eval('#player', (player) => player.hidden), false);
  const pictures = {};
  for (const view of ['original', 'result']) {
    await choose(page, 'view', view);
    for (const place of [0, 600]) {
      await goTo(page, place);
      (pictures[place] ??= []).push(await picture(page));
    }
  }
  assert.notEqual(pictures[0][0], pictures[600][0]);
  assert.notEqual(pictures[0][1], pictures[600][1]);
  await choose(page, 'view', 'split');
  assert.equal(await textOf(page, 'play'), 'Play');
});

for (const [name, extension] of Object.entries({ Draco: KHRDracoMeshCompression, meshoptimizer: EXTMeshoptCompression })) {
  test(`what ${name} compressed is opened`, { skip }, async () => {
    await drop(open.page, 'packed.glb', await bytesOf(movingHill(), extension));
    assert.equal(await textOf(open.page, 'error'), '');
    assert.match(await textOf(open.page, 'mesh-name'), /^packed.glb: 32,761 vertices/);
    assert.equal(await textOf(open.page, 'status'), 'Done');
  });
}

test('where people want less motion an animation waits', { skip }, async () => {
  const { page } = open;
  await page.emulateMediaFeatures([{ name: 'prefers-reduced-motion', value: 'reduce' }]);
  await drop(page, 'moving.glb', await bytesOf(movingHill()));
  assert.equal(await textOf(page, 'play'), 'Play');
  await page.emulateMediaFeatures([]);
  await drop(page, 'moving.glb', await bytesOf(movingHill()));
  assert.equal(await textOf(page, 'play'), 'Pause');
  await page.click('#play');
  assert.equal(await textOf(page, 'play'), 'Play');
});

test('nothing went wrong on the console', { skip }, () => assert.deepEqual(open.problems, []));
