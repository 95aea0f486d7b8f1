// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// The project's README has the pictures that are there, and these are small. What makes them is pictures/make.js.
import assert from 'node:assert/strict';
import { readFileSync, readdirSync, statSync } from 'node:fs';
import { test } from 'node:test';

import { drawCurve, pointsOf } from '../pictures/curve.js';

const MOST_BYTES = 400000;
const root = new URL('../../../', import.meta.url);

test('the README shows all pictures, which have 400 kB together', () => {
  const names = readdirSync(new URL('docs/pictures/', root));
  const shown = [...readFileSync(new URL('README.md', root), 'utf8').matchAll(/docs\/pictures\/([\w.-]+)/g)].map(([, name]) => name);
  assert.deepEqual([...new Set(shown)].sort(), names.sort());
  assert.ok(names.reduce((sum, name) => sum + statSync(new URL(`docs/pictures/${name}`, root)).size, 0) <= MOST_BYTES);
});

test('a curve has a line for each codec, whose bits grow with what is asked', async () => {
  const positions = Float32Array.from({ length: 3 * 400 }, (_, i) => [Math.floor(i / 3) % 20, Math.floor(i / 60), Math.sin(i / 90)][i % 3]);
  const indices = Uint32Array.from({ length: 19 * 19 * 3 }, (_, i) => {
    const face = Math.floor(i / 3);
    return Math.floor(face / 19) * 20 + (face % 19) + [0, 1, 20][i % 3];
  });
  const series = await pointsOf({ origin: [0, 0, 0], positions, indices }, 27);
  for (const [name, points] of Object.entries(series)) {
    const sorted = [...points].sort((a, b) => a.share - b.share);
    assert.ok(sorted[0].bits > sorted.at(-1).bits, name);
  }
  assert.equal(drawCurve(series, 'a grid').match(/<polyline/g).length, 3);
});
