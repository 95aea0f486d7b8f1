// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// What materials mirror, as the build stores it; without three.js, so that it is fetched meanwhile.

/** Half floats: all red values, all green, all blue; null where there are none to be had. */
export async function fetchStudio() {
  try {
    const { ok, body } = await fetch(new URL('./studio.gz', import.meta.url));
    return ok ? new Uint16Array(await new Response(body.pipeThrough(new DecompressionStream('gzip'))).arrayBuffer()) : null;
  } catch {
    return null;
  }
}
