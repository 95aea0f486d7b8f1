// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Edges of parts that were designed: there faces do not share their normals, so that what is flat looks flat.

/** Faces at one vertex whose normals are closer than this have one normal. */
const CREASE = Math.cos((40 * Math.PI) / 180);
/** Between these are few angles where edges are designed, and many where a sensor or a generator made them. */
const [CLEARLY_SMOOTH, CLEARLY_SHARP] = [25, 55].map((degrees) => Math.cos((degrees * Math.PI) / 180));
/** Of angles that are not smooth, how many may be unclear: of parts up to 42 % are, of what was scanned 64 % and more. */
const MOST_UNCLEAR = 0.5;
/** At vertices of more faces all share one normal: the time would grow with the square. */
const MOST_FACES = 256;

/** n x 3: normals of faces, as long as twice their area. */
function faceNormals(positions, indices) {
  const normals = new Float32Array(indices.length);
  for (let i = 0; i < indices.length; i += 3) {
    const [a, b, c] = [3 * indices[i], 3 * indices[i + 1], 3 * indices[i + 2]];
    const [ux, uy, uz] = [positions[b] - positions[a], positions[b + 1] - positions[a + 1], positions[b + 2] - positions[a + 2]];
    const [vx, vy, vz] = [positions[c] - positions[a], positions[c + 1] - positions[a + 1], positions[c + 2] - positions[a + 2]];
    normals[i] = uy * vz - uz * vy;
    normals[i + 1] = uz * vx - ux * vz;
    normals[i + 2] = ux * vy - uy * vx;
  }
  return normals;
}

/** Corners by vertices: those of vertex v are corners[starts[v]] up to corners[starts[v + 1]]. */
function cornersOfVertices(indices, count) {
  const starts = new Uint32Array(count + 1);
  for (const vertex of indices) ++starts[vertex + 1];
  for (let v = 0; v < count; ++v) starts[v + 1] += starts[v];
  const next = starts.slice(0, count);
  const corners = new Uint32Array(indices.length);
  indices.forEach((vertex, corner) => (corners[next[vertex]++] = corner));
  return { starts, corners };
}

function cosine(normals, f, g) {
  const dot = normals[f] * normals[g] + normals[f + 1] * normals[g + 1] + normals[f + 2] * normals[g + 2];
  const lengths = (normals[f] ** 2 + normals[f + 1] ** 2 + normals[f + 2] ** 2) * (normals[g] ** 2 + normals[g + 1] ** 2 + normals[g + 2] ** 2);
  return lengths > 0 ? dot / Math.sqrt(lengths) : 1;
}
const faceOf = (corner) => corner - (corner % 3);

/** Whether the mesh has edges that were designed: faces that meet do so either smoothly or sharply. */
export function hasCreases(positions, indices) {
  const normals = faceNormals(positions, indices);
  const { starts, corners } = cornersOfVertices(indices, positions.length / 3);
  let [unclear, sharp] = [0, 0];
  for (let v = 0; v + 1 < starts.length; ++v) {
    const last = Math.min(starts[v + 1], starts[v] + MOST_FACES);
    for (let i = starts[v] + 1; i < last; ++i) {
      const angle = cosine(normals, faceOf(corners[i - 1]), faceOf(corners[i]));
      if (angle < CLEARLY_SHARP) ++sharp;
      else if (angle < CLEARLY_SMOOTH) ++unclear;
    }
  }
  return sharp > 0 && unclear <= MOST_UNCLEAR * (unclear + sharp);
}

/**
 * `normals`, n x 3, of vertices with those added that creases need; `indices` that name them; `copies`: for each one that was added the
 * vertex that it is a copy of.
 */
export function creasedNormals(positions, indices) {
  const faces = faceNormals(positions, indices);
  const count = positions.length / 3;
  const { starts, corners } = cornersOfVertices(indices, count);
  const normals = new Array(3 * count).fill(0);
  const made = Uint32Array.from(indices);
  const copies = [];
  for (let v = 0; v < count; ++v) {
    const [first, last] = [starts[v], starts[v + 1]];
    const isOne = last - first > MOST_FACES;
    const seen = []; // [vertex, x, y, z]
    for (let i = first; i < last; ++i) {
      const own = faceOf(corners[i]);
      let [x, y, z] = [0, 0, 0];
      for (let j = first; j < last; ++j) {
        const other = faceOf(corners[j]);
        if (!isOne && cosine(faces, own, other) < CREASE) continue;
        x += faces[other];
        y += faces[other + 1];
        z += faces[other + 2];
      }
      const length = Math.hypot(x, y, z);
      [x, y, z] = length > 0 ? [x / length, y / length, z / length] : [0, 0, 1];
      let vertex = seen.find((one) => one[1] === x && one[2] === y && one[3] === z)?.[0];
      if (vertex === undefined) {
        vertex = seen.length === 0 ? v : count + copies.push(v) - 1;
        seen.push([vertex, x, y, z]);
        [normals[3 * vertex], normals[3 * vertex + 1], normals[3 * vertex + 2]] = [x, y, z];
      }
      made[corners[i]] = vertex;
      if (isOne) {
        for (let j = first; j < last; ++j) made[corners[j]] = vertex;
        break;
      }
    }
    if (first === last) normals[3 * v + 2] = 1;
  }
  return { normals: Float32Array.from(normals), indices: made, copies: Uint32Array.from(copies) };
}

/** Each vertex, with copies behind those that they are copies of. */
export function withoutCopies(count, copies) {
  const numbers = Uint32Array.from({ length: count }, (_, vertex) => vertex);
  numbers.set(copies, count - copies.length);
  return numbers;
}

/** Rows of `values` with those of copies behind. */
export function withCopies(values, components, copies) {
  const count = values.length / components;
  const all = new values.constructor((count + copies.length) * components);
  all.set(values);
  copies.forEach((vertex, i) => {
    for (let c = 0; c < components; ++c) all[(count + i) * components + c] = values[vertex * components + c];
  });
  return all;
}
