// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// A result beside what others make of the same mesh.
import { Superseded } from '../latest-job.js';
import { requestOf } from '../peers/request.js';
import { showPeers } from './report.js';

/** `source`: { mesh }; `result`: of the workshop. */
export async function compareWithOthers(find, workshop, { mesh }, { bytes, info }) {
  const isExact = !(info.quality.maxError > 0);
  find('peers-status').textContent = isExact ? 'The result is exact: there is no error to compare at.' : 'Computing';
  find('peers').replaceChildren(); // those of an earlier result
  if (isExact) return;
  try {
    const request = requestOf(mesh, info, bytes.length);
    showPeers(find('peers'), request, await workshop.compare(request));
    find('peers-status').textContent = `${request.names.join(', ')}.`;
  } catch (error) {
    if (!(error instanceof Superseded)) find('peers-status').textContent = `This could not be computed: ${error.message}`;
  }
}
