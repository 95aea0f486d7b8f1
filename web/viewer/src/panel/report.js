// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// What came out: bytes of every chunk, achieved errors, and what others take.
import { sizeAt } from '../peers/at-error.js';
import { formatBytes, formatNumber, formatPercent } from '../units.js';

const CHUNKS = {
  CONN: 'Faces',
  SEAM: 'Seams',
  FGRP: 'Groups of faces',
  ORDR: 'Order',
  DELT: 'Delta coordinates',
  ANCH: 'Anchors',
  POSN: 'Positions',
};
const ATTRIBUTE_UNITS = { normal: '°', tangent: '°', color: ' of 255' };

function tableRow(cells, header = false) {
  const row = document.createElement('tr');
  cells.forEach((text, i) => {
    const cell = document.createElement(header || i === 0 ? 'th' : 'td');
    if (cell.tagName === 'TH') cell.scope = header ? 'col' : 'row';
    cell.textContent = text;
    row.append(cell);
  });
  return row;
}

function fill(table, rows, head) {
  const body = document.createElement('tbody');
  body.append(...rows.map((cells) => tableRow(cells)));
  const header = document.createElement('thead');
  if (head) header.append(tableRow(head, true));
  table.replaceChildren(header, body);
}

/** Rows of chunks, with the attributes by their names; what is left is the header. */
function chunkRows({ chunks, attributes }, size) {
  let next = 0;
  const rows = chunks.map(({ tag, codedBytes }) => {
    const name = tag === 'ATTR' ? attributes[next++].name : (CHUNKS[tag] ?? tag);
    return [name, codedBytes];
  });
  const rest = size - rows.reduce((sum, [, bytes]) => sum + bytes, 0);
  return [...rows, ['Header, table of chunks', rest], ['Whole stream', size]];
}

export function showBytes(table, info, size) {
  const rows = chunkRows(info, size).map(([name, bytes]) => [name, formatBytes(bytes), formatPercent(bytes / size)]);
  fill(table, rows, ['Chunk', 'Size', 'Share']);
}

export function showErrors(table, { quality, attributes }, diagonal) {
  const rows = [
    ['Visual (VDE)', quality.vde],
    ['Positional (LFE)', quality.lfe],
    ['Largest', quality.maxError],
  ].map(([name, value]) => [name, formatNumber(value), formatPercent(value / diagonal)]);
  for (const { name, kind, error } of attributes) {
    rows.push([name, error === 0 ? 'exact' : formatNumber(error) + (ATTRIBUTE_UNITS[kind] ?? ''), '']);
  }
  fill(table, rows, ['Error', 'Model units', 'Of diagonal']);
}

/** `request`: of requestOf(); the others: of dracoPoints() and meshoptPoints(), as they are at the request's error. */
export function showPeers(table, { own, maxError }, { draco, meshopt }) {
  const row = (name, bytes) => [name, formatBytes(bytes), `${formatNumber(bytes / own)} ×`];
  fill(
    table,
    [
      row('deltamesh', own),
      row('Draco', sizeAt(draco, maxError)),
      row('meshoptimizer', sizeAt(meshopt, maxError)),
      row('the same, deflated', sizeAt(meshopt, maxError, 'deflated')),
    ],
    ['Codec', 'Size', 'Ratio'],
  );
}
