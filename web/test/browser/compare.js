// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Two pictures of the same scene, in the page.

export const SIDE = 512;
const MOST_DIFFERENCE = 8;

/** Directions from an asset to the cameras that see it: the last is below, where terrains cannot be seen. */
export const VIEWS = [[0.4, 0.5, 0.9], [-0.9, 0.6, 0.3], [0.2, -0.9, -0.5]];

function isFar(a, b) {
  for (let c = 0; c < 3; ++c) if (Math.abs(a[c] - b[c]) > MOST_DIFFERENCE) return true;
  return false;
}

/**
 * `different`: share of pixels with a channel that is further off than 8 of 255; `covered`: share of the first picture's pixels that
 * are as far from its corner, where nothing but the background is.
 */
export function comparePictures(a, b) {
  const background = a.subarray(0, 4);
  let [different, covered] = [0, 0];
  for (let i = 0; i < a.length; i += 4) {
    const pixel = a.subarray(i, i + 4);
    if (isFar(pixel, b.subarray(i, i + 4))) ++different;
    if (isFar(pixel, background)) ++covered;
  }
  return { different: different / (a.length / 4), covered: covered / (a.length / 4) };
}

/** The drawing's pixels; call it before the browser shows the next frame. */
export function pixelsOf(canvas) {
  const context = new OffscreenCanvas(SIDE, SIDE).getContext('2d', { willReadFrequently: true });
  context.drawImage(canvas, 0, 0, SIDE, SIDE);
  return context.getImageData(0, 0, SIDE, SIDE).data;
}
