// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// What others are asked for: the attributes that they know, at the largest errors of a stream.

/** Others have these; tangents, generic attributes and those of skins are left out on all sides. */
function isKnown({ kind, components, values }) {
  if (kind === 'normal') return components === 3 && values instanceof Float32Array;
  if (kind === 'uv') return components === 2 && values instanceof Float32Array;
  return kind === 'color' && values instanceof Uint8Array;
}

/** `info`: of the stream, whose attributes are in the mesh's order. `own`: the stream's bytes without what is left out. */
export function requestOf(mesh, info, size) {
  const pairs = mesh.attributes.map((attribute, i) => ({ ...attribute, ...info.attributes[i], values: attribute.values }));
  const attributes = pairs.filter(isKnown);
  const others = pairs.filter((attribute) => !isKnown(attribute));
  return {
    positions: mesh.positions,
    indices: mesh.indices,
    maxError: info.quality.maxError,
    attributes: attributes.map(({ kind, components, values, error }) => ({ kind, components, values, error })),
    own: others.reduce((rest, { codedBytes }) => rest - codedBytes, size),
    names: ['Faces', 'positions', ...attributes.map(({ name }) => name)],
  };
}
