// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Meshes become one.

/** One mesh, with a group of faces for each; attributes that all of them have are kept. */
export function joinMeshes(meshes) {
  if (meshes.length === 1) return meshes[0];
  const join = (arrays) => {
    const joined = new arrays[0].constructor(arrays.reduce((sum, { length }) => sum + length, 0));
    let at = 0;
    for (const array of arrays) {
      joined.set(array, at);
      at += array.length;
    }
    return joined;
  };
  let before = 0;
  const indices = meshes.map((mesh) => {
    const shifted = mesh.indices.map((index) => index + before);
    before += mesh.positions.length / 3;
    return shifted;
  });
  const same = (a) => (b) => b.name === a.name && b.components === a.components && b.values.constructor === a.values.constructor;
  const attributes = meshes[0].attributes
    .map((attribute) => meshes.map((mesh) => mesh.attributes.find(same(attribute))))
    .filter((parts) => parts.every(Boolean))
    .map((parts) => ({ ...parts[0], values: join(parts.map(({ values }) => values)) }));
  return {
    positions: join(meshes.map(({ positions }) => positions)),
    indices: join(indices),
    groups: join(meshes.map((mesh, i) => new Uint32Array(mesh.indices.length / 3).fill(i))),
    attributes,
  };
}
