// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Primitives as the mesh of one stream, in the order and under the names that the program gives them (gltf_ext/src/stream).
const KINDS = { NORMAL: 'normal', TANGENT: 'tangent', TEXCOORD: 'uv', COLOR: 'color', JOINTS: 'joints', WEIGHTS: 'weights' };
const LOOKS = new Set(['NORMAL', 'TANGENT', 'TEXCOORD', 'COLOR']);

/** Every array of a primitive that a stream can hold: of its attributes, then of its morph targets. `target`: null for the base. */
export function columnsOf(primitive) {
  const columns = primitive.listSemantics().map((semantic) => ({ semantic, target: null, accessor: primitive.getAttribute(semantic) }));
  for (const [t, target] of primitive.listTargets().entries())
    for (const semantic of target.listSemantics()) columns.push({ semantic, target: t, accessor: target.getAttribute(semantic) });
  return columns;
}

const isPosition = ({ semantic, target }) => semantic === 'POSITION' && target === null;
const isFloat = (accessor) => accessor.getArray() instanceof Float32Array;

function kindOf({ semantic, target, accessor }) {
  const kind = target === null ? KINDS[semantic.split('_')[0]] : undefined;
  const size = accessor.getElementSize();
  const isSmall = [Uint8Array, Uint16Array].some((Array) => accessor.getArray() instanceof Array);
  const isLevels = isFloat(accessor) || (accessor.getNormalized() && isSmall);
  const fits = {
    normal: isFloat(accessor) && size === 3,
    tangent: isFloat(accessor) && size === 4,
    uv: isFloat(accessor) && size === 2,
    color: isLevels && size >= 3,
    joints: isSmall,
    weights: isLevels,
  };
  return fits[kind] ? kind : 'generic';
}

/** Only generic attributes have names, by which they get bounds: displacements in floats "d" and their semantic. */
function nameOf(column) {
  if (kindOf(column) !== 'generic') return '';
  if (column.target === null) return column.semantic;
  return isFloat(column.accessor) ? `d${column.semantic}` : '';
}

/** A vertex's values where its primitive does not have the attribute. */
function fillerOf(kind, accessor) {
  const array = accessor.getArray();
  const row = new array.constructor(accessor.getElementSize());
  const full = isFloat(accessor) ? 1 : 2 ** (8 * array.BYTES_PER_ELEMENT) - 1;
  if (kind === 'color') row.fill(full);
  if (kind === 'weights' || kind === 'tangent') row[0] = full;
  if (kind === 'normal') row[2] = full;
  if (kind === 'tangent') row[3] = full;
  return row;
}

const bytesOf = (array) => new Uint8Array(array.buffer, array.byteOffset, array.byteLength);

/** Finds accessors of the same content. */
export class Contents {
  #numbers = new Map();
  #known = new Map();

  of(accessor) {
    if (!this.#numbers.has(accessor)) this.#numbers.set(accessor, this.#find(accessor));
    return this.#numbers.get(accessor);
  }

  #find(accessor) {
    const array = accessor.getArray();
    const bytes = bytesOf(array);
    let hash = 0;
    for (const byte of bytes) hash = (Math.imul(hash, 31) + byte) | 0;
    const key = [array.constructor.name, accessor.getElementSize(), accessor.getNormalized(), bytes.length, hash].join(' ');
    const others = this.#known.get(key) ?? [];
    this.#known.set(key, others);
    let same = others.find((other) => other.bytes.every((byte, i) => byte === bytes[i]));
    if (!same) others.push((same = { bytes }));
    return same;
  }
}

/** The primitives of a mesh as one, each a group; those with the same arrays share vertices. */
export class Merged {
  #contents;
  #blocks = [];
  #columns = new Map();
  #groups = [];

  /** `contents`: of the document. */
  constructor(primitives, contents) {
    this.#contents = contents;
    for (const primitive of primitives) {
      const columns = columnsOf(primitive);
      const key = columns.flatMap(({ semantic, target, accessor }) => [semantic, target, contents.of(accessor)]);
      let block = this.#blocks.find((other) => other.key.length === key.length && other.key.every((part, i) => part === key[i]));
      if (!block) {
        block = { key, columns, positions: columns.find(isPosition).accessor.getArray(), values: new Map() };
        this.#blocks.push(block);
      }
      const count = block.positions.length / 3;
      const indices = primitive.getIndices()?.getArray() ?? Uint32Array.from({ length: count }, (_, i) => i);
      this.#groups.push({ block, indices: indices.subarray(0, indices.length - (indices.length % 3)) });
      for (const column of columns.filter((one) => !isPosition(one))) {
        const name = this.keyOf(columns, column);
        if (!this.#columns.has(name)) this.#columns.set(name, column);
        block.values.set(name, column.accessor.getArray());
      }
    }
  }

  /** Of the attribute that holds a column's values: the first column of the primitive that is the same stands for all. */
  keyOf(columns, column) {
    const same = (other) =>
      !isPosition(other) && this.#contents.of(other.accessor) === this.#contents.of(column.accessor) &&
      kindOf(other) === kindOf(column) && nameOf(other) === nameOf(column);
    const { semantic, target, accessor } = columns.find(same);
    return [semantic, target, accessor.getArray().constructor.name, accessor.getElementSize(), accessor.getNormalized()].join(' ');
  }

  get keys() {
    return [...this.#columns.keys()];
  }

  /** Triangles of a group that draw something, unless there are no others: none has two corners that nothing tells apart. */
  #drawn({ block, indices }) {
    const fixed = block.columns.filter(({ semantic, target }) => target !== null || !LOOKS.has(semantic.split('_')[0]));
    const together = (a, b) =>
      a === b || fixed.every(({ accessor }) => {
        const array = accessor.getArray();
        const size = accessor.getElementSize();
        for (let k = 0; k < size; ++k) if (array[a * size + k] !== array[b * size + k]) return false;
        return true;
      });
    const kept = [];
    for (let i = 0; i + 2 < indices.length; i += 3) {
      const [a, b, c] = indices.subarray(i, i + 3);
      if (!together(a, b) && !together(b, c) && !together(c, a)) kept.push(a, b, c);
    }
    return kept.length > 0 ? kept : indices;
  }

  mesh({ lossless = false, keepOrder = false, keepUnreferenced = false } = {}) {
    const isFree = !keepOrder && !keepUnreferenced;
    const faces = this.#groups.map((group) => (isFree && !lossless ? this.#drawn(group) : group.indices));
    const columns = [...this.#columns].map(([key, column]) => ({ key, column, kind: kindOf(column), filler: fillerOf(kindOf(column), column.accessor) }));
    const size = 12 + columns.reduce((sum, { filler }) => sum + filler.byteLength, 0);
    const known = new Map();
    const rows = [];
    const numbers = new Map();
    for (const block of this.#blocks) {
      const used = new Uint8Array(block.positions.length / 3).fill(keepUnreferenced ? 1 : 0);
      this.#groups.forEach((group, g) => group.block === block && faces[g].forEach((index) => (used[index] = 1)));
      numbers.set(block, this.#addRows(block, used, { columns, size, known, rows, isFree, lossless }));
    }
    const all = new Uint8Array(rows.length * size);
    rows.forEach((row, i) => all.set(row, i * size));
    let offset = 12;
    const attributes = columns.map(({ column, kind, filler }) => {
      const values = valuesOf(all, rows.length, size, offset, filler.constructor, filler.length);
      offset += filler.byteLength;
      return { name: nameOf(column), kind, components: filler.length, normalized: column.accessor.getNormalized(), linear: kind === 'color', values };
    });
    return {
      positions: valuesOf(all, rows.length, size, 0, Float32Array, 3),
      indices: Uint32Array.from(faces.flatMap((face, g) => Array.from(face, (index) => numbers.get(this.#groups[g].block)[index]))),
      groups: faces.length > 1 ? faces.flatMap((face, g) => new Array(face.length / 3).fill(g)) : null,
      attributes,
    };
  }

  /** Rows of a block's vertices that are used, equal ones once; returns the row of every vertex. */
  #addRows(block, used, { columns, size, known, rows, isFree, lossless }) {
    const numbers = new Uint32Array(used.length);
    const decoder = new TextDecoder('latin1');
    for (let v = 0; v < used.length; ++v) {
      if (!used[v]) continue;
      const row = new Uint8Array(size);
      const position = block.positions.slice(3 * v, 3 * v + 3);
      if (!lossless) position.forEach((x, k) => (position[k] = x + 0)); // one zero, or mirrored halves would not meet
      row.set(bytesOf(position));
      let offset = 12;
      for (const { key, filler } of columns) {
        const values = block.values.get(key);
        row.set(bytesOf(values ? values.subarray(v * filler.length, (v + 1) * filler.length) : filler), offset);
        offset += filler.byteLength;
      }
      const text = isFree ? decoder.decode(row) : v;
      if (isFree && known.has(text)) {
        numbers[v] = known.get(text);
        continue;
      }
      numbers[v] = rows.push(row) - 1;
      if (isFree) known.set(text, numbers[v]);
    }
    return numbers;
  }
}

function valuesOf(all, count, stride, offset, Array, components) {
  const values = new Array(count * components);
  const bytes = bytesOf(values);
  const size = values.BYTES_PER_ELEMENT * components;
  for (let i = 0; i < count; ++i) bytes.set(all.subarray(i * stride + offset, i * stride + offset + size), i * size);
  return values;
}
