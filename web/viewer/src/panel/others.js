// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// A result beside what others make of the same mesh.
import { Superseded } from '../latest-job.js';
import { requestOf } from '../peers/request.js';
import { drawChart } from './chart.js';
import { showPeers } from './report.js';

const known = new WeakMap(); // results of a source, for the chart

function pointsOf(source, point) {
  if (!known.has(source)) known.set(source, []);
  known.get(source).push(point);
  return known.get(source);
}

/** `source`: { mesh }; `result`: of the workshop. */
export async function compareWithOthers(find, workshop, source, { bytes, info }) {
  const { mesh } = source;
  const isExact = !(info.quality.maxError > 0);
  find('peers-status').textContent = isExact ? 'The result is exact: there is no error to compare at.' : 'Computing';
  for (const id of ['peers', 'chart']) find(id).replaceChildren(); // those of an earlier result
  find('chart').setAttribute('hidden', '');
  if (isExact) return;
  try {
    const request = requestOf(mesh, info, bytes.length);
    const inUse = { error: request.maxError, bytes: request.own };
    const own = pointsOf(source, inUse);
    const { draco, meshopt } = await workshop.compare(request);
    showPeers(find('peers'), request, { draco, meshopt });
    const deflated = meshopt.map(({ error, deflated }) => ({ error, bytes: deflated }));
    find('chart').removeAttribute('hidden');
    drawChart(find('chart'), [
      { name: 'deltamesh', points: own, isOwn: true, inUse },
      { name: 'Draco', points: draco },
      { name: 'meshoptimizer, deflated', points: deflated },
    ]);
    find('peers-status').textContent = `${request.names.join(', ')}.`;
  } catch (error) {
    if (!(error instanceof Superseded)) find('peers-status').textContent = `This could not be computed: ${error.message}`;
  }
}
