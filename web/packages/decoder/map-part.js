// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What maps on disk and maps that change share: the module, and how a part is handed out.

export const MAP_MODULE = { url: () => new URL('./map.wasm', import.meta.url), text: () => import('./text/map.js') };

/** Of readStream()'s result what a part has. */
export function partMesh({ vertexCount, triangleCount, origin, positions, indices, groups, attributes }) {
  const own = attributes.map(({ name, kind, components, normalized, linear, values }) => ({ name, kind, components, normalized, linear, values }));
  return { vertexCount, triangleCount, origin, positions, indices, groups, attributes: own };
}
