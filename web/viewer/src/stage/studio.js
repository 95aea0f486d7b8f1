// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// What materials mirror: a texture that the build makes (bake-studio.js), so that no graphics card has to filter it.
import { CompressedCubeTexture, HalfFloatType, LinearFilter, LinearMipmapLinearFilter, RGBAFormat } from 'three';

/** Sides of its levels, from what a mirror shows to what a rough surface does. */
export const SIDES = [128, 64, 32, 16, 8];
const FACES = 6;
const ONE = 0x3c00; // as a half float

/** `planes`: all red values, all green, all blue, `stride` of each; they become texels with four values. */
function texelsOf(planes, from, count, stride) {
  const texels = new Uint16Array(4 * count).fill(ONE);
  for (let c = 0; c < 3; ++c) {
    for (let i = 0; i < count; ++i) texels[4 * i + c] = planes[c * stride + from + i];
  }
  return texels;
}

/** In the form that materials of three.js take from PMREMGenerator; `planes`: of fetchStudio(). */
export function studioTexture(planes) {
  const images = Array.from({ length: FACES }, () => ({ mipmaps: [] }));
  let from = 0;
  for (const side of SIDES) {
    for (const image of images) {
      image.mipmaps.push({ width: side, height: side, data: texelsOf(planes, from, side * side, planes.length / 3) });
      from += side * side;
    }
  }
  for (const image of images) [image.width, image.height] = [SIDES[0], SIDES[0]];
  const texture = new CompressedCubeTexture(images, RGBAFormat, HalfFloatType);
  [texture.minFilter, texture.magFilter] = [LinearMipmapLinearFilter, LinearFilter];
  texture.isPMREMTexture = true;
  texture.needsUpdate = true;
  return texture;
}
