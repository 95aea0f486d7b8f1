// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// The box around parts that come and go.

export const keyOf = ({ level, cell }) => [level, ...cell].join('_');

function boxOf(positions) {
  const box = { min: [Infinity, Infinity, Infinity], max: [-Infinity, -Infinity, -Infinity] };
  for (let i = 0; i < positions.length; ++i) {
    const axis = i % 3;
    box.min[axis] = Math.min(box.min[axis], positions[i]);
    box.max[axis] = Math.max(box.max[axis], positions[i]);
  }
  return box;
}

export class Box {
  #parts = new Map();
  #origin = null; // of what is drawn: the centre when the first parts came

  set(key, positions) {
    this.#parts.set(keyOf(key), boxOf(positions));
  }

  remove(key) {
    this.#parts.delete(keyOf(key));
  }

  /** `center`: what positions are drawn relative to, which stays; `middle`: of the box now, relative to it; null: there are no parts. */
  frame() {
    const boxes = [...this.#parts.values()];
    if (boxes.length === 0) return null;
    const min = [0, 1, 2].map((axis) => boxes.reduce((least, box) => Math.min(least, box.min[axis]), Infinity));
    const max = [0, 1, 2].map((axis) => boxes.reduce((most, box) => Math.max(most, box.max[axis]), -Infinity));
    const middle = min.map((value, axis) => (value + max[axis]) / 2);
    this.#origin ??= middle;
    return {
      center: this.#origin,
      middle: middle.map((value, axis) => value - this.#origin[axis]),
      diagonal: Math.hypot(...max.map((value, axis) => value - min[axis])),
    };
  }
}
