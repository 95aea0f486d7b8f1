// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// One sentence with one number: what became of the mesh.
import { PRESETS } from '../settings.js';
import { formatNumber, formatSize } from '../units.js';

export function headlineOf(preset, original, result) {
  const words = PRESETS[preset]?.words ?? `${formatNumber(original / result)} times smaller`;
  return `${formatSize(original)} → ${formatSize(result)}, ${words}`;
}
