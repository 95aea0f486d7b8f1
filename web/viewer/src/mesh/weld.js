// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Rows of numbers that have the same bits become one vertex.

/**
 * `columns`: [{ values, components }], rows of 32-bit floats or of bytes. Returns `rows`, the first of each set of equal rows, and
 * `numbers`: for every row its vertex, below rows.length.
 */
export function weld(columns, count) {
  const words = columns.flatMap(({ values, components }) =>
    values.BYTES_PER_ELEMENT === 4
      ? [{ words: new Uint32Array(values.buffer, values.byteOffset, values.length), components }]
      : [{ words: values, components }],
  );
  const slots = new Int32Array(2 ** Math.ceil(Math.log2(2 * count + 2))).fill(-1);
  const mask = slots.length - 1;
  const rows = [];
  const numbers = new Uint32Array(count);
  const hashOf = (row) => {
    let hash = 0;
    for (const { words: column, components } of words) {
      for (let i = row * components; i < (row + 1) * components; ++i) {
        hash = Math.imul(hash ^ column[i], 0x9e3779b1);
        hash ^= hash >>> 15;
      }
    }
    return hash & mask;
  };
  const equal = (a, b) =>
    words.every(({ words: column, components }) => {
      for (let i = 0; i < components; ++i) {
        if (column[a * components + i] !== column[b * components + i]) return false;
      }
      return true;
    });
  for (let row = 0; row < count; ++row) {
    let slot = hashOf(row);
    while (slots[slot] >= 0 && !equal(rows[slots[slot]], row)) slot = (slot + 1) & mask;
    if (slots[slot] < 0) slots[slot] = rows.push(row) - 1;
    numbers[row] = slots[slot];
  }
  return { rows: Uint32Array.from(rows), numbers };
}

/** The chosen rows of a column. */
export function pickRows(values, components, rows) {
  const picked = new values.constructor(rows.length * components);
  for (let i = 0; i < rows.length; ++i) {
    for (let c = 0; c < components; ++c) picked[i * components + c] = values[rows[i] * components + c];
  }
  return picked;
}
