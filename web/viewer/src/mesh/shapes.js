// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Shapes that examples are made of: grids of points, open or closed.

/** A grid of `rows` x `columns` quads; where a direction is closed its last vertices are its first. */
export function gridIndices(rows, columns, { isRing = false, isTube = false } = {}) {
  const indices = new Uint32Array(6 * rows * columns);
  const [height, width] = [isRing ? rows : rows + 1, isTube ? columns : columns + 1];
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

/** `pointAt(u, v)`: [x, y, z] for u along the rows and v along the columns, 0 to 1. */
export function surface(rows, columns, pointAt, closed = {}) {
  const [height, width] = [closed.isRing ? rows : rows + 1, closed.isTube ? columns : columns + 1];
  const positions = new Float32Array(3 * height * width);
  for (let row = 0; row < height; ++row)
    for (let column = 0; column < width; ++column) positions.set(pointAt(row / rows, column / columns), 3 * (row * width + column));
  return { positions, indices: gridIndices(rows, columns, closed) };
}

/** Turned around the z axis: `profile(t)` gives [radius, z] from bottom to top; `relief(t, angle)` is added to the radius. */
export function turned(rows, columns, [x, y], profile, relief = () => 0) {
  const pointAt = (t, v) => {
    const [angle, [radius, z]] = [2 * Math.PI * v, profile(t)];
    const length = radius + relief(t, angle) * Math.min(1, 20 * radius);
    return [x + length * Math.cos(angle), y + length * Math.sin(angle), z];
  };
  return surface(rows, columns, pointAt, { isTube: true });
}

const rounded = (value) => Math.sign(value) * Math.abs(value) ** 0.28;

/** A box with round edges: `center`, and half of its sides. `dent(x, y, z)`: added to z, for x, y, z from -1 to 1. */
export function cushion(rows, columns, center, half, dent = () => 0) {
  const pointAt = (u, v) => {
    const [down, around] = [Math.PI * (u - 0.5), 2 * Math.PI * v];
    const ring = rounded(Math.cos(down));
    const unit = [ring * rounded(Math.cos(around)), ring * rounded(Math.sin(around)), rounded(Math.sin(down))];
    const place = unit.map((value, axis) => center[axis] + half[axis] * value);
    place[2] += dent(...unit);
    return place;
  };
  return surface(rows, columns, pointAt, { isTube: true });
}

const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = (a) => a.map((x) => x / Math.hypot(...a));

function knotCurve(t) {
  const radius = 2 + Math.cos(3 * t);
  return [radius * Math.cos(2 * t), radius * Math.sin(2 * t), 1.2 * Math.sin(3 * t)];
}

/** A trefoil knot with a twisted relief. */
export function knot(rows, columns) {
  const pointAt = (u, v) => {
    const [t, angle] = [2 * Math.PI * u, 2 * Math.PI * v];
    const center = knotCurve(t);
    const along = unit(minus(knotCurve(t + 1e-4), center));
    const side = unit(cross(along, [0, 0, 1]));
    const up = cross(side, along);
    const radius = 0.52 + 0.05 * Math.cos(6 * angle + 24 * t) + 0.012 * Math.cos(90 * t) * Math.cos(12 * angle);
    const [x, y] = [radius * Math.cos(angle), radius * Math.sin(angle)];
    return center.map((value, i) => value + x * side[i] + y * up[i]);
  };
  return surface(rows, columns, pointAt, { isRing: true, isTube: true });
}
