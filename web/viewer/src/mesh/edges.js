// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Edges of triangles, each once.

/** Pairs of vertices, the lower first. `numbers`: the vertex that stands for each; default itself. */
export function uniqueEdges(indices, count, numbers) {
  const first = new Int32Array(count).fill(-1); // of a vertex' list of edges to higher vertices
  const next = [];
  const edges = [];
  const add = (a, b) => {
    if (a === b) return;
    const [low, high] = a < b ? [a, b] : [b, a];
    for (let edge = first[low]; edge >= 0; edge = next[edge]) {
      if (edges[2 * edge + 1] === high) return;
    }
    next.push(first[low]);
    first[low] = edges.push(low, high) / 2 - 1;
  };
  const at = numbers ? (corner) => numbers[indices[corner]] : (corner) => indices[corner];
  for (let i = 0; i < indices.length; i += 3) {
    add(at(i), at(i + 1));
    add(at(i + 1), at(i + 2));
    add(at(i + 2), at(i));
  }
  return Uint32Array.from(edges);
}
