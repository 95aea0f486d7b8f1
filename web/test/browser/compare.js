// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Two pictures of the same scene, in the page.

export const SIDE = 512;
const MOST_DIFFERENCE = 8;

/** `share`: of pixels with a channel that is further off than 8 of 255; `colors`: how many the first picture has. */
export function comparePictures(a, b) {
  let different = 0;
  for (let i = 0; i < a.length; i += 4) {
    let largest = 0;
    for (let c = 0; c < 3; ++c) largest = Math.max(largest, Math.abs(a[i + c] - b[i + c]));
    if (largest > MOST_DIFFERENCE) ++different;
  }
  return { share: different / (a.length / 4), colors: new Set(new Uint32Array(a.buffer)).size };
}

/** The drawing's pixels; call it before the browser shows the next frame. */
export function pixelsOf(canvas) {
  const context = new OffscreenCanvas(SIDE, SIDE).getContext('2d', { willReadFrequently: true });
  context.drawImage(canvas, 0, 0, SIDE, SIDE);
  return context.getImageData(0, 0, SIDE, SIDE).data;
}
