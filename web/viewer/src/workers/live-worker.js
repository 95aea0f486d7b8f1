// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// A map that changes, by a WebSocket: messages are applied as they come, and what is shown goes to the page whenever that is done with the
// last. Messages of the page: { address, map } first, then { isFree: true }.
import { DeltameshError } from '@deltamesh/decoder';
import { createReceiver } from '@deltamesh/decoder/receiver';

import { Box } from '../map/box.js';
import { buffersOf, displayOf } from '../mesh/display.js';

const TICK_MILLISECONDS = 50;
const WAIT_MILLISECONDS = 2000; // before the next try to connect
const MOST_MESSAGE_BYTES = 2 ** 18; // [MAP-25]
const MOST_WAITING_BYTES = 2 ** 18; // what has not been sent
const TOLD_MILLISECONDS = 3000; // how long a refused message is told of, and until silence is

let address;
let map;
let receiver;
let socket;
let isFree = true;
let refused = null; // { what, when }
const box = new Box();
const traffic = { bytes: 0, messages: 0, since: performance.now(), last: null, changed: null };

/** What is wrong now, or ''. */
function problem(now) {
  if (socket?.readyState !== WebSocket.OPEN) return `no connection to ${address}: trying again`;
  if (refused && now - refused.when < TOLD_MILLISECONDS) return `a message was refused: ${refused.what}`;
  if (traffic.last === null && now - traffic.since > TOLD_MILLISECONDS) return `${address} says nothing of a map ${map}: the page's address has another by &map=`;
  return '';
}

function refuse(what) {
  refused = { what, when: performance.now() };
}

function take({ data }) {
  traffic.bytes += data.byteLength ?? data.length;
  ++traffic.messages;
  traffic.last = performance.now();
  if (!(data instanceof ArrayBuffer)) return refuse('a text, where maps are bytes');
  if (data.byteLength > MOST_MESSAGE_BYTES) return refuse(`${data.byteLength} bytes`);
  const error = receiver.apply(new Uint8Array(data));
  if (error) refuse(error.message);
}

function connect() {
  traffic.since = performance.now();
  socket = new WebSocket(address);
  socket.binaryType = 'arraybuffer';
  socket.onmessage = take;
  socket.onclose = () => setTimeout(connect, WAIT_MILLISECONDS);
}

function send(now) {
  if (socket.readyState !== WebSocket.OPEN || socket.bufferedAmount > MOST_WAITING_BYTES) return;
  const messages = receiver.messages(now / 1000);
  if (messages instanceof DeltameshError) return refuse(messages.message);
  for (const message of messages) socket.send(message);
}

/** All that changed at once: half of it may have cracks. */
function change() {
  const { changed, removed, lackingCount, faultCount } = receiver.takeChange();
  if (!changed) return null;
  const parts = changed.map((key) => ({ key, mesh: receiver.find(key) })).filter(({ mesh }) => mesh && !(mesh instanceof DeltameshError));
  for (const key of removed) box.remove(key);
  for (const { key, mesh } of parts) box.set(key, mesh.positions);
  const frame = box.frame();
  const shown = parts.map(({ key, mesh }) => ({ key, triangleCount: mesh.triangleCount, display: displayOf(mesh, frame) }));
  return { parts: shown, removed, frame, lackingCount, faultCount };
}

function tick() {
  const now = performance.now();
  send(now);
  if (!isFree) return;
  isFree = false;
  const news = change();
  if (news?.parts.length > 0 || news?.removed.length > 0) traffic.changed = now;
  const age = (then) => (then === null ? null : (now - then) / 1000);
  const told = { bytes: traffic.bytes, messages: traffic.messages, seconds: age(traffic.last), changedSeconds: age(traffic.changed) };
  self.postMessage({ news, traffic: told, problem: problem(now) }, news?.parts.flatMap(({ display }) => buffersOf(display)) ?? []);
}

self.onmessage = async ({ data }) => {
  if (data.isFree) return (isFree = true);
  ({ address, map } = data);
  try {
    receiver = await createReceiver({ map, file: new URL('./map.wasm', import.meta.url) });
    connect();
    setInterval(tick, TICK_MILLISECONDS);
  } catch (error) {
    self.postMessage({ failure: error.message });
  }
};
