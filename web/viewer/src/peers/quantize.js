// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Lattices and directions of so many steps, and the largest errors that they make.

const DEGREES = 180 / Math.PI;

/** The lowest corner and the longest side of the bounding box of rows of `components` numbers. */
export function boxOf(values, components) {
  const min = new Array(components).fill(Infinity);
  const max = new Array(components).fill(-Infinity);
  for (let i = 0; i < values.length; ++i) {
    const axis = i % components;
    if (values[i] < min[axis]) min[axis] = values[i];
    if (values[i] > max[axis]) max[axis] = values[i];
  }
  return { min, side: Math.max(...max.map((value, axis) => value - min[axis])) };
}

/** Largest distance of a row from the lattice that has `steps` steps along the longest side. */
export function latticeError(values, { min, side }, steps) {
  const components = min.length;
  const step = side / steps;
  let largest = 0;
  for (let i = 0; i < values.length; i += components) {
    let square = 0;
    for (let axis = 0; axis < components; ++axis) {
      const place = (values[i + axis] - min[axis]) / step;
      const off = (place - Math.floor(place + 0.5)) * step;
      square += off * off;
    }
    if (square > largest) largest = square;
  }
  return Math.sqrt(largest);
}

/** Largest angle, degrees, between normals and the points of Draco's octahedron of `bits` bits. Source: its OctahedronToolBox. */
export function octahedronError(normals, bits) {
  const center = (2 ** bits - 2) / 2;
  let lowest = 1;
  for (let i = 0; i < normals.length; i += 3) {
    const [x, y, z] = [normals[i], normals[i + 1], normals[i + 2]];
    const scale = center / (Math.abs(x) + Math.abs(y) + Math.abs(z));
    if (!Number.isFinite(scale)) continue;
    const a = Math.floor(x * scale + 0.5);
    let b = Math.floor(y * scale + 0.5);
    let c = center - Math.abs(a) - Math.abs(b);
    if (c < 0) {
      b += b > 0 ? c : -c;
      c = 0;
    }
    if (z < 0) c = -c;
    const cosine = (x * a + y * b + z * c) / Math.sqrt((x * x + y * y + z * z) * (a * a + b * b + c * c));
    if (cosine < lowest) lowest = cosine;
  }
  return DEGREES * Math.acos(Math.max(-1, lowest));
}

/** The fewest bits, `least` to `most`, for which `errorOf(bits)` is at most `bound`; `most` where none do. */
export function fewestBits(errorOf, bound, least, most) {
  let bits = least;
  while (bits < most && !(errorOf(bits) <= bound)) ++bits;
  return bits;
}

/** Bytes in levels, so that no byte is off by more than `error`. */
export function levelsOf(bytes, error) {
  const step = 2 * Math.floor(error) + 1;
  return bytes.map((value) => Math.floor((value + (step - 1) / 2) / step));
}
