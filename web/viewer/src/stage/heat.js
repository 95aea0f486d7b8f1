// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Colours of heat maps, for the graphics card and for the scale beside it.
import { DataTexture, LinearFilter, SRGBColorSpace } from 'three';

/** Blue inward, red outward; and dark to light. */
const DIVERGING = ['#2166ac', '#67a9cf', '#f7f7f7', '#ef8a62', '#b2182b'];
export const SEQUENTIAL = ['#440154', '#3b528b', '#21918c', '#5ec962', '#fde725'];

export const HEATS = {
  signed: { colors: DIVERGING, isSigned: true, name: 'Signed distance', unit: 'units, outward positive' },
  vde: { colors: SEQUENTIAL, isSigned: false, name: 'Visual error', unit: 'units' },
  normal: { colors: SEQUENTIAL, isSigned: false, name: 'Normals’ angle', unit: 'degrees' },
  tint: { colors: SEQUENTIAL, isSigned: false, name: 'Colours’ error', unit: '255ths, rms of red, green and blue' },
};

const WIDTH = 256;

export function heatTexture(colors) {
  const stops = colors.map((color) => [1, 3, 5].map((at) => parseInt(color.slice(at, at + 2), 16)));
  const pixels = new Uint8Array(4 * WIDTH).fill(255);
  for (let i = 0; i < WIDTH; ++i) {
    const place = Math.min((i / (WIDTH - 1)) * (stops.length - 1), stops.length - 1 - 1e-9);
    const [low, high] = [stops[Math.floor(place)], stops[Math.floor(place) + 1]];
    pixels.set(low.map((value, c) => Math.round(value + (place % 1) * (high[c] - value))), 4 * i);
  }
  const texture = new DataTexture(pixels, WIDTH, 1);
  texture.colorSpace = SRGBColorSpace;
  texture.minFilter = texture.magFilter = LinearFilter;
  texture.needsUpdate = true;
  return texture;
}

/** 99 % of sampled values are within it; as roundLimit(). */
export function heatLimit(values) {
  const step = Math.max(1, Math.floor(values.length / 5000));
  const sample = [];
  for (let i = 0; i < values.length; i += step) sample.push(Math.abs(values[i]));
  return roundLimit(sample.sort((a, b) => a - b)[Math.floor(0.99 * (sample.length - 1))]);
}

/** The end of a scale that reaches to `high`: 1, 2 or 5 times a power of ten. */
export function roundLimit(high) {
  if (!(high > 0)) return 1e-9;
  const power = 10 ** Math.floor(Math.log10(high));
  return power * [1, 2, 5, 10].find((digit) => digit * power >= high * 0.999);
}
