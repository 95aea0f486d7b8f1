// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// A map that changes, from the publisher of examples/map_udp.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { createSocket } from 'node:dgram';
import { once } from 'node:events';
import { existsSync } from 'node:fs';
import { after, before, test } from 'node:test';
import { fileURLToPath } from 'node:url';

import { DeltameshError } from '@deltamesh/decoder';
import { createReceiver } from '@deltamesh/decoder/receiver';

const publisher = fileURLToPath(new URL('../../../../build/release/tests/map_udp/map_udp_publisher', import.meta.url));
const skip = existsSync(publisher) ? false : 'the publisher of examples/map_udp is not built';
const PARTS = 64;

let running;
let link;
before(async () => {
  if (skip) return;
  running = spawn(publisher, ['0', '60'], { stdio: ['ignore', 'pipe', 'inherit'] });
  const [line] = await once(running.stdout, 'data');
  link = createSocket('udp4');
  await new Promise((resolve) => link.connect(Number(line), '127.0.0.1', resolve));
});
after(() => {
  link?.close();
  running?.kill();
});

const keyOf = ({ level, cell }) => [level, ...cell].join('_');

/** Keeps `shown` as the receiver says, by `onMessage` first, until `isDone`. */
async function follow(receiver, shown, isDone, onMessage = () => {}) {
  const take = (message) => {
    onMessage(message);
    const error = receiver.apply(message);
    assert.ok(error === null || error.code === 200, String(error)); // what was on its way to a receiver that has begun anew
  };
  const show = () => {
    const { changed, removed } = receiver.takeChange();
    for (const key of removed) assert.ok(shown.delete(keyOf(key)));
    for (const key of changed) shown.set(keyOf(key), receiver.find(key));
  };
  link.on('message', take);
  for (const end = performance.now() + 30000; !isDone(); await new Promise((resolve) => setTimeout(resolve, 50))) {
    assert.ok(performance.now() < end, `${shown.size} parts`);
    for (const message of receiver.messages(performance.now() / 1000)) link.send(message);
    show();
  }
  link.off('message', take);
  show(); // what came while the loop slept
}

test('parts come, with colours; damaged messages change nothing; a receiver begins anew', { skip }, async () => {
  const receiver = await createReceiver({ map: 7 });
  const shown = new Map();
  const messages = [];
  await follow(receiver, shown, () => shown.size === PARTS, (message) => messages.push(message));
  const triangles = [...shown.values()].reduce((sum, { triangleCount }) => sum + triangleCount, 0);
  assert.equal(triangles, PARTS * 512);
  for (const { vertexCount, positions, indices, attributes } of shown.values()) {
    assert.equal(positions.length, 3 * vertexCount);
    assert.ok(indices.every((vertex) => vertex < vertexCount));
    assert.deepEqual(attributes.map(({ kind, components, values }) => [kind, components, values.length]), [['color', 3, 3 * vertexCount]]);
  }
  assert.equal(receiver.find({ level: 0, cell: [1000, 0, 0] }), null);
  for (const message of messages.slice(0, 100)) {
    const damaged = message.slice();
    damaged[damaged.length >> 1] ^= 1;
    assert.ok(receiver.apply(damaged) instanceof DeltameshError);
    assert.ok(receiver.apply(damaged.subarray(0, damaged.length >> 1)) instanceof DeltameshError);
  }
  assert.ok(receiver.apply(new Uint8Array(0)) instanceof DeltameshError);
  assert.deepEqual(receiver.takeChange(), { changed: [], removed: [], lackingCount: 0, faultCount: 0 });
  receiver.release();
  assert.deepEqual(receiver.takeChange().removed.map(keyOf).sort(), [...shown.keys()].sort());
  shown.clear();
  await follow(receiver, shown, () => shown.size === PARTS);
});

test('messages of another map are errors', { skip }, async () => {
  const receiver = await createReceiver({ map: 7 });
  const other = await createReceiver({ map: 2n ** 64n - 1n });
  const shown = new Map();
  await follow(receiver, shown, () => shown.size === PARTS, (message) => assert.ok(other.apply(message) instanceof DeltameshError));
});
