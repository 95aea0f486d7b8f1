// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Reads a map's manifest, and its parts one by one.
import { DeltameshError } from '@deltamesh/decoder';
import { openMap } from '@deltamesh/decoder/map';

import { buffersOf, displayOf } from '../mesh/display.js';
import { answerCalls } from './answer.js';

let module;
const maps = new Map(); // by turns: what is shown, and what is being opened

function check(outcome) {
  if (outcome instanceof DeltameshError) throw outcome;
  return outcome;
}

/** Around the parts' boxes. */
function frameOfParts(parts) {
  const min = [0, 1, 2].map((axis) => Math.min(...parts.map(({ box }) => box.min[axis])));
  const max = [0, 1, 2].map((axis) => Math.max(...parts.map(({ box }) => box.max[axis])));
  return {
    center: min.map((value, axis) => (value + max[axis]) / 2),
    diagonal: Math.hypot(...min.map((value, axis) => max[axis] - value)),
  };
}

answerCalls({
  setup: () => (module = WebAssembly.compileStreaming(fetch(new URL('./map.wasm', import.meta.url)))),
  /** `manifest`: a file. `turn`: of this call; `shown`: of the map that is shown. `center`: of the picture, where there is one already. */
  open: async ({ manifest, turn, shown, center }) => {
    const map = check(await openMap(new Uint8Array(await manifest.arrayBuffer()), { file: module }));
    const parts = map.parts.map((part, number) => ({ ...part, number })).filter(({ isFinest }) => isFinest);
    if (parts.length === 0) throw new Error('the map has no parts');
    const frame = frameOfParts(parts);
    if (center) frame.center = center;
    for (const other of maps.keys()) if (other !== shown) maps.delete(other);
    maps.set(turn, { map, frame });
    return { result: { parts, frame } };
  },
  /** A part of the map that was opened by `turn`. */
  part: async ({ turn, number, file }) => {
    if (!maps.has(turn)) throw new Error('the map is no longer open: open its folder again');
    const { map, frame } = maps.get(turn);
    const display = displayOf(check(map.decode(number, new Uint8Array(await file.arrayBuffer()))), frame);
    return { result: display, transfer: buffersOf(display) };
  },
});
