// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// What the panel says of a result, and what is downloaded.
import { formatBytes, formatNumber } from '../units.js';
import { showBytes, showErrors } from './report.js';

/** `source`: { mesh, frame, file }; `name`: of files. */
export function showResult(find, { bytes, info }, source, name) {
  showBytes(find('bytes'), info, bytes.length);
  showErrors(find('errors'), info, source.frame.diagonal);
  const bits = formatNumber((8 * bytes.length) / info.vertexCount);
  find('summary').textContent =
    `${formatBytes(bytes.length)}, ${bits} bits per vertex, ${info.geometry}; ` +
    `compressed ${info.encodeMilliseconds ? `in ${formatNumber(info.encodeMilliseconds / 1000)} s` : 'beforehand'}, decoded in ${formatNumber(info.decodeMilliseconds)} ms`;
  const link = find('download');
  if (link.href) URL.revokeObjectURL(link.href);
  link.href = URL.createObjectURL(new Blob([bytes], { type: 'application/octet-stream' }));
  link.download = `${name}.dmsh`;
  link.hidden = find('download-glb').hidden = false;
  find('download-packed').hidden = !source.file;
}

export function forgetResult(find) {
  for (const id of ['bytes', 'errors', 'peers', 'chart']) find(id).replaceChildren();
  for (const id of ['summary', 'headline']) find(id).textContent = '';
  for (const id of ['download', 'download-glb', 'download-packed']) find(id).hidden = true;
}

/** Of the mesh's arrays, as they are in memory. */
export const rawBytes = ({ positions, indices, attributes }) =>
  positions.byteLength + indices.byteLength + attributes.reduce((sum, { values }) => sum + values.byteLength, 0);
