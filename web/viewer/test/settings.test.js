// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Settings, links and options.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { BOUNDS, DEFAULTS, encodeOptions, fromHash, toHash, withPreset } from '../src/settings.js';

test('a link holds what differs from the defaults, and gives it back', () => {
  assert.equal(toHash(DEFAULTS), '');
  const settings = { ...DEFAULTS, preset: 'own', vde: 0.03, maxError: null, view: 'side', effort: '0', example: 'terrain' };
  assert.deepEqual(fromHash(`#${toHash(settings)}`), settings);
});

test('a link has the name of a preset alone; bounds in a link are one’s own', () => {
  const tiny = withPreset(DEFAULTS, 'tiny');
  assert.equal(toHash(tiny), 'preset=tiny');
  assert.deepEqual(fromHash('#preset=tiny'), tiny);
  assert.deepEqual(fromHash('#preset=tiny&maxError=0.1'), { ...tiny, preset: 'own', maxError: 0.1 });
  assert.equal(encodeOptions(withPreset(tiny, 'exact')).lossless, true);
  assert.equal(encodeOptions(tiny).lossless, false);
});

test('what a link says wrongly is ignored', () => {
  const hash = '#vde=-1&lfe=x&maxError=&size=1e99&normals=off&view=constructor&example=../x&effort=7&nothing=1';
  assert.deepEqual(fromHash(hash), DEFAULTS);
});

test('defaults and starts of bounds are in their ranges', () => {
  for (const { id, min, max, start } of BOUNDS) {
    assert.ok(start >= min && start <= max, id);
    assert.ok(DEFAULTS[id] === null || (DEFAULTS[id] >= min && DEFAULTS[id] <= max), id);
  }
});

test('options of the encoder leave out what is off', () => {
  const options = encodeOptions({ ...DEFAULTS, size: 9000, maxError: null });
  assert.equal(options.maxError, undefined);
  assert.equal(options.targetBytes, 9000);
  assert.equal(options.effort, 1);
  assert.equal(options.colorRms, undefined);  // the encoder tells photographs from labels
  assert.ok(Math.abs(encodeOptions({ ...DEFAULTS, colors: 40 }).colorRms - 2.55) < 1e-9);
});
