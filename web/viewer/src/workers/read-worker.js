// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Reads files, makes examples, and prepares what the graphics card gets.
import { DeltameshError, createDecoder } from '@deltamesh/decoder';

import { buffersOf, displayOf, frameOf } from '../mesh/display.js';
import { uniqueEdges } from '../mesh/edges.js';
import { makeExample } from '../mesh/examples.js';
import { readMesh } from '../mesh/read-mesh.js';
import { writeGlb } from '../mesh/write-glb.js';
import { answerCalls } from './answer.js';

let modules;

function shown({ mesh, ...about }) {
  const frame = frameOf(mesh.positions);
  const display = displayOf(mesh, frame);
  const own = [mesh.positions, mesh.indices, mesh.groups, ...mesh.attributes.map(({ values }) => values)];
  const buffers = [...own.filter(Boolean).map(({ buffer }) => buffer), ...buffersOf(display)];
  return { result: { mesh, frame, display, ...about }, transfer: [...new Set(buffers)] };
}

answerCalls({
  setup: (message) => ({ modules } = message),
  read: async ({ file, others }) => shown(await readMesh(file, { others, modules })),
  example: ({ name }) => shown(makeExample(name)),
  edges: ({ indices, count }) => {
    const edges = uniqueEdges(indices, count);
    return { result: edges, transfer: [edges.buffer] };
  },
  glb: async ({ bytes }) => {
    const decoder = await createDecoder({ files: modules });
    const mesh = await decoder.decode(bytes);
    if (mesh instanceof DeltameshError) throw mesh;
    const glb = writeGlb(mesh);
    return { result: glb, transfer: [glb.buffer] };
  },
});
