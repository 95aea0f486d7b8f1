// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Colours of the page have the contrast that WCAG 2.2 asks for at level AA, in light and dark.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';

const TEXT = 4.5;
const PARTS = 3; // borders of what is used, marks of focus
const PAIRS = [
  ['text', ['page', 'panel', 'stage'], TEXT],
  ['quiet', ['page', 'panel'], TEXT],
  ['alarm', ['panel'], TEXT],
  ['on-accent', ['accent'], TEXT],
  ['accent', ['page', 'panel', 'stage'], PARTS],
  ['edge', ['page', 'panel'], PARTS],
];

const css = readFileSync(new URL('../style.css', import.meta.url), 'utf8');
const colorsIn = (text) => Object.fromEntries([...text.matchAll(/--([\w-]+): (#[0-9a-f]{6});/g)].map(([, name, color]) => [name, color]));
const [light, dark] = css.split('prefers-color-scheme: dark').slice(0, 2).map(colorsIn);

function luminance(color) {
  const [r, g, b] = [1, 3, 5].map((at) => {
    const value = parseInt(color.slice(at, at + 2), 16) / 255;
    return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
  });
  return 0.2126 * r + 0.7152 * g + 0.0722 * b;
}

function contrast(a, b) {
  const [high, low] = [luminance(a), luminance(b)].sort((x, y) => y - x);
  return (high + 0.05) / (low + 0.05);
}

for (const [name, colors] of Object.entries({ light, dark: { ...light, ...dark } })) {
  test(`contrast in ${name} colours`, (t) => {
    for (const [front, backs, least] of PAIRS) {
      for (const back of backs) {
        const ratio = contrast(colors[front], colors[back]);
        t.diagnostic(`${front} on ${back}: ${ratio.toFixed(2)}, at least ${least}`);
        assert.ok(ratio >= least, `${front} on ${back}: ${ratio}`);
      }
    }
  });
}

test('black on white has the largest contrast there is', () => assert.equal(contrast('#000000', '#ffffff'), 21));
