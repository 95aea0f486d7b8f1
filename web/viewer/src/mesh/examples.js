// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Meshes that are generated, so that something is seen at once.

/** A grid of `rows` x `columns` quads over (u, v); where it is closed its last vertices are its first. */
function gridIndices(rows, columns, isClosed) {
  const indices = new Uint32Array(6 * rows * columns);
  const [height, width] = isClosed ? [rows, columns] : [rows + 1, columns + 1];
  let at = 0;
  for (let row = 0; row < rows; ++row) {
    for (let column = 0; column < columns; ++column) {
      const vertex = (r, c) => (r % height) * width + (c % width);
      const [a, b, c, d] = [vertex(row, column), vertex(row, column + 1), vertex(row + 1, column + 1), vertex(row + 1, column)];
      indices.set([a, b, c, a, c, d], at);
      at += 6;
    }
  }
  return indices;
}

function knotCurve(t) {
  const radius = 2 + Math.cos(3 * t);
  return [radius * Math.cos(2 * t), radius * Math.sin(2 * t), 1.2 * Math.sin(3 * t)];
}

const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = (a) => a.map((x) => x / Math.hypot(...a));

/** A trefoil knot with a twisted relief. */
function knot(rows = 520, columns = 64) {
  const positions = new Float32Array(3 * rows * columns);
  for (let row = 0; row < rows; ++row) {
    const t = (2 * Math.PI * row) / rows;
    const center = knotCurve(t);
    const along = unit(minus(knotCurve(t + 1e-4), center));
    const side = unit(cross(along, [0, 0, 1]));
    const up = cross(side, along);
    for (let column = 0; column < columns; ++column) {
      const angle = (2 * Math.PI * column) / columns;
      const relief = 0.05 * Math.cos(6 * angle + 24 * t) + 0.012 * Math.cos(90 * t) * Math.cos(12 * angle);
      const radius = 0.52 + relief;
      const [x, y] = [radius * Math.cos(angle), radius * Math.sin(angle)];
      positions.set(center.map((value, i) => value + x * side[i] + y * up[i]), 3 * (row * columns + column));
    }
  }
  return { positions, indices: gridIndices(rows, columns, true), attributes: [] };
}

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
  return { positions, indices: gridIndices(rows, columns, false), attributes: [color] };
}

/** Their names in links, with those that people see. */
export const EXAMPLES = { knot: { label: 'Knot', make: knot }, terrain: { label: 'Terrain', make: terrain } };

export function makeExample(name) {
  const { make } = EXAMPLES[name] ?? EXAMPLES.knot;
  return { origin: [0, 0, 0], groups: null, ...make() };
}
