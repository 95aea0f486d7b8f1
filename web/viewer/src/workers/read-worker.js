// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Reads files, makes examples, and prepares what the graphics card gets. What reads files comes when it is needed: examples are there first.
import { buffersOf, displayOf, frameOf } from '../mesh/display.js';
import { uniqueEdges } from '../mesh/edges.js';
import { exampleOf, makeExample } from '../mesh/examples.js';
import { fetchPrepared } from '../mesh/prepared.js';
import { writeGlb } from '../mesh/write-glb.js';
import { answerCalls, modules } from './answer.js';
import { decode, resultOf } from './result.js';

function shown({ mesh, ...about }) {
  const frame = frameOf(mesh.positions);
  const display = displayOf(mesh, frame);
  const own = [mesh.positions, mesh.indices, mesh.groups, ...mesh.attributes.map(({ values }) => values)];
  const buffers = [...own.filter(Boolean).map(({ buffer }) => buffer), ...buffersOf(display)];
  return { result: { mesh, frame, display, ...about }, transfer: [...new Set(buffers)] };
}

async function example({ name }) {
  const stored = fetchPrepared(exampleOf(name));
  const { result, transfer } = shown(makeExample(name));
  const prepared = await resultOf(await stored, result.frame);
  return { result: { ...result, prepared }, transfer: [...transfer, prepared.bytes.buffer, prepared.order.buffer, ...buffersOf(prepared.display)] };
}

answerCalls({
  read: async ({ file, others }) => {
    const { readMesh } = await import('../mesh/read-mesh.js');
    return shown(await readMesh(file, { others, modules }));
  },
  example,
  edges: ({ indices, count }) => {
    const edges = uniqueEdges(indices, count);
    return { result: edges, transfer: [edges.buffer] };
  },
  glb: async ({ bytes }) => {
    const glb = writeGlb(await decode(bytes));
    return { result: glb, transfer: [glb.buffer] };
  },
});
