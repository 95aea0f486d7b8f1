// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Meshes that are generated, so that something is seen at once.

import { room } from './room.js';
import { gridIndices, knot } from './shapes.js';

function noise(x, y) {
  let height = 0;
  let [scale, angle] = [1, 0.7];
  for (let octave = 0; octave < 7; ++octave) {
    const [u, v] = [x * Math.cos(angle) + y * Math.sin(angle), y * Math.cos(angle) - x * Math.sin(angle)];
    height += scale * (1 - Math.abs(Math.sin(u + 0.6 * Math.sin(1.3 * v)) * Math.cos(0.9 * v)));
    [x, y, scale, angle] = [x * 1.9 + 3.1, y * 1.9 + 1.7, scale * 0.48, angle + 1.9];
  }
  return height;
}

/** Metres; a ramp of colours from valley to peak. */
function terrain(rows = 180, columns = 180) {
  const count = (rows + 1) * (columns + 1);
  const positions = new Float32Array(3 * count);
  const colors = new Uint8Array(3 * count);
  const ramp = [[62, 92, 60], [121, 132, 82], [150, 127, 100], [236, 236, 240]];
  for (let row = 0, at = 0; row <= rows; ++row) {
    for (let column = 0; column <= columns; ++column, at += 3) {
      const height = noise(column / 32, row / 32);
      positions.set([column * 5, row * 5, height * 90], at);
      const place = Math.min(2.999, Math.max(0, (height - 0.3) * 1.9));
      const [low, high, share] = [ramp[Math.floor(place)], ramp[Math.floor(place) + 1], place % 1];
      colors.set(low.map((value, i) => Math.round(value + share * (high[i] - value))), at);
    }
  }
  const color = { kind: 'color', name: 'color', components: 3, normalized: true, values: colors };
  return { positions, indices: gridIndices(rows, columns), attributes: [color] };
}

/** Their names in links, with those that people see. */
export const EXAMPLES = {
  room: { label: 'Room', make: room },
  knot: { label: 'Knot', make: (rows = 520, columns = 64) => ({ ...knot(rows, columns), attributes: [] }) },
  terrain: { label: 'Terrain', make: terrain },
};

/** The name, or where no example has it that of the first. */
export const exampleOf = (name) => (Object.hasOwn(EXAMPLES, name) ? name : 'room');

/** As readMesh(), but `materials` are what three.js is told of them. */
export function makeExample(name) {
  const { materials = null, ...mesh } = EXAMPLES[exampleOf(name)].make();
  return { mesh: { origin: [0, 0, 0], groups: null, ...mesh }, up: 'z', materials };
}
