// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Reads files, and prepares what the graphics card gets. What reads files comes when it is needed: edges need little.
import { withoutCopies } from '../mesh/creases.js';
import { uniqueEdges } from '../mesh/edges.js';
import { writeGlb } from '../mesh/write-glb.js';
import { answerCalls, modules } from './answer.js';
import { decode, shown } from './result.js';

answerCalls({
  read: async ({ file, others }) => {
    const { readMesh } = await import('../mesh/read-mesh.js');
    return shown(await readMesh(file, { others, modules }));
  },
  edges: ({ indices, count, copies }) => {
    const edges = uniqueEdges(indices, count, copies && withoutCopies(count, copies));
    return { result: edges, transfer: [edges.buffer] };
  },
  glb: async ({ bytes }) => {
    const glb = writeGlb(await decode(bytes));
    return { result: glb, transfer: [glb.buffer] };
  },
});
