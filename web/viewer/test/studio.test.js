// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { DataUtils } from 'three';

import { bakeStudio } from '../bake-studio.js';
import { SIDES, studioTexture } from '../src/stage/studio.js';

const texture = studioTexture(bakeStudio());
/** [red, green, blue] in the middle of a face: 0 and 1 look along x, 2 and 3 along y, 4 and 5 along z. */
function middleOf(face, level) {
  const { width, data } = texture.image[face].mipmaps[level];
  return Array.from(data.subarray(4 * (width / 2) * (width + 1), 4 * (width / 2) * (width + 1) + 3), DataUtils.fromHalfFloat);
}

test('each level has its side on each face', () => {
  assert.equal(texture.image.length, 6);
  for (const { mipmaps } of texture.image) assert.deepEqual(mipmaps.map(({ width, data }) => [width, data.length]), SIDES.map((side) => [side, 4 * side * side]));
});

test('a mirror shows lamps where they are; three.js turns x round', () => {
  assert.deepEqual(middleOf(2, 0).map(Math.round), [9, 9, 9], 'ceiling');
  assert.deepEqual(middleOf(3, 0).map((value) => value.toFixed(2)), ['0.34', '0.30', '0.27'], 'floor');
  const [right, left] = [0, 1].map((face) => texture.image[face].mipmaps[1].data.reduce((most, value, i) => (i % 4 === 3 ? most : Math.max(most, DataUtils.fromHalfFloat(value))), 0));
  assert.ok(right > 6.5 && left < 5.5, `the larger lamp at -x is behind the first face: ${right}, ${left}`);
});

test('what is rough mirrors all around, most from above', () => {
  const [up, down] = [2, 3].map((face) => middleOf(face, SIDES.length - 1)[1]);
  assert.ok(up > 1.2 && up < 4, `${up}`);
  assert.ok(down > 0.3 && down < 0.8, `${down}`);
});
