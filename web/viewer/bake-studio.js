// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// What materials mirror: a room with large lamps, boxes that shine by themselves. Y is up. Each level of the cube has the light that a
// surface of some roughness mirrors, as PMREMGenerator of three.js makes it: GGX, seen along the normal.
import { DataUtils } from 'three';

import { SIDES } from './src/stage/studio.js';

/** Size, place and light: [red, green, blue], 1 is white. */
const LAMPS = [
  [[7, 0.2, 3], [0, 5.6, 0], [9, 9, 8.6]],
  [[0.2, 3, 5], [-6.6, 2.2, 1], [6, 6.4, 7.2]],
  [[3, 2.4, 0.2], [2.5, 2.4, -6.6], [7.5, 6.6, 5.4]],
  [[0.2, 2, 1.2], [6.6, 1.6, 2.5], [4.5, 4.2, 3.8]],
  [[14, 0.2, 14], [0, -2.2, 0], [0.34, 0.3, 0.27]],
];
const WALLS = [0.62, 0.64, 0.68];
/** Directions for all texels of a level. */
const RAYS = 2 ** 20;

/** Distance to the box along `direction` from the room's middle, or Infinity. */
function distanceTo([size, place], direction) {
  let [near, far] = [0, Infinity];
  for (let axis = 0; axis < 3; ++axis) {
    const a = (place[axis] - size[axis] / 2) / direction[axis];
    const b = (place[axis] + size[axis] / 2) / direction[axis];
    near = Math.max(near, Math.min(a, b));
    far = Math.min(far, Math.max(a, b));
  }
  return near < far ? near : Infinity;
}

function lightFrom(direction) {
  let [nearest, light] = [Infinity, WALLS];
  for (const lamp of LAMPS) {
    const distance = distanceTo(lamp, direction);
    if (distance < nearest) [nearest, light] = [distance, lamp[2]];
  }
  return light;
}

/** Of a cube's face, as OpenGL has them; x is turned round, as three.js does with cubes that are no targets of drawing. `u`, `v`: -1 to 1. */
function directionOf(face, u, v) {
  const [x, y, z] = [[1, -v, -u], [-1, -v, u], [u, 1, v], [u, -1, -v], [u, -v, 1], [-u, -v, -1]][face];
  const length = Math.hypot(x, y, z);
  return [-x / length, y / length, z / length];
}

const reversed = (i) => {
  let value = 0;
  for (let bit = 0.5; i > 0; bit /= 2, i >>= 1) value += bit * (i & 1);
  return value;
};

/** Directions [along the normal, across it, across both] that a surface mirrors to its normal; the first is their weight, too. */
function lobeOf(roughness, count) {
  const alpha2 = roughness ** 4;
  const lobe = [];
  for (let i = 0; i < count; ++i) {
    const share = (i + 0.5) / count;
    const q = 1 - share + alpha2 * share;
    const along = (1 - share - alpha2 * share) / q;
    if (along <= 0) continue;
    const across = (2 * roughness ** 2 * Math.sqrt(share * (1 - share))) / q;
    const angle = 2 * Math.PI * reversed(i);
    lobe.push([along, across * Math.cos(angle), across * Math.sin(angle)]);
  }
  return lobe;
}

function mirrored(normal, lobe) {
  const [x, y, z] = normal;
  const length = Math.hypot(x, z) || 1;
  const tangent = Math.hypot(x, z) > 0.01 ? [z / length, 0, -x / length] : [1, 0, 0];
  const other = [y * tangent[2] - z * tangent[1], z * tangent[0] - x * tangent[2], x * tangent[1] - y * tangent[0]];
  const sum = [0, 0, 0];
  let weights = 0;
  for (const [a, b, c] of lobe) {
    const light = lightFrom(normal.map((value, axis) => a * value + b * tangent[axis] + c * other[axis]));
    for (let i = 0; i < 3; ++i) sum[i] += a * light[i];
    weights += a;
  }
  return sum.map((value) => value / weights);
}

/** What a mirror shows within a texel. */
function seen(face, x, y, side, samples) {
  const sum = [0, 0, 0];
  for (let i = 0; i < samples; ++i) {
    const [dx, dy] = [(i + 0.5) / samples, reversed(i) + 0.5 / samples];
    const light = lightFrom(directionOf(face, (2 * (x + dx)) / side - 1, (2 * (y + dy)) / side - 1));
    for (let c = 0; c < 3; ++c) sum[c] += light[c] / samples;
  }
  return sum;
}

/** Half floats: red of all texels, green, blue; level by level, face by face. */
export function bakeStudio() {
  const texels = SIDES.reduce((sum, side) => sum + 6 * side * side, 0);
  const planes = new Uint16Array(3 * texels);
  let at = 0;
  SIDES.forEach((side, level) => {
    const samples = Math.ceil(RAYS / (6 * side * side));
    const lobe = lobeOf(1 - Math.sqrt(1 - level / (SIDES.length - 1)), samples);
    for (let face = 0; face < 6; ++face) {
      for (let texel = 0; texel < side * side; ++texel, ++at) {
        const [x, y] = [texel % side, Math.floor(texel / side)];
        const light = level === 0 ? seen(face, x, y, side, samples) : mirrored(directionOf(face, (2 * x + 1) / side - 1, (2 * y + 1) / side - 1), lobe);
        light.forEach((value, c) => (planes[c * texels + at] = DataUtils.toHalfFloat(value)));
      }
    }
  });
  return planes;
}
