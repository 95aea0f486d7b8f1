// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Whether the processor draws, as no graphics card does: then several samples for each pixel would take most of the time. Asking wakes the
// graphics card's process, for which the page does not wait. Only the name tells: Chromium makes a context for `failIfMajorPerformanceCaveat`, too.

function isDrawnBySoftware() {
  const gl = new OffscreenCanvas(1, 1).getContext('webgl2');
  const names = gl?.getExtension('WEBGL_debug_renderer_info');
  const name = names ? gl.getParameter(names.UNMASKED_RENDERER_WEBGL) : '';
  gl?.getExtension('WEBGL_lose_context')?.loseContext();
  return /swiftshader|llvmpipe|softpipe|basic render|software/i.test(name);
}

self.postMessage(isDrawnBySoftware());
