// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// A robot's map, generated, without its ceilings, so that rooms are seen from above: as PLY.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

const VERTEX_BYTES = 15; // three floats and three bytes
const FACE_BYTES = 13; // a byte and three integers
const VERTICES = 60000;
/** Share of the height that is kept. */
const KEPT = 0.62;

export function cutMap(program) {
  const folder = mkdtempSync(join(tmpdir(), 'deltamesh-pictures-'));
  const path = join(folder, 'rooms.ply');
  execFileSync(program, ['generate', 'rooms', path, '--vertices', String(VERTICES)], { stdio: 'ignore' });
  const ply = readFileSync(path);
  rmSync(folder, { recursive: true });
  const end = ply.indexOf('end_header\n') + 11;
  const header = ply.toString('latin1', 0, end);
  const count = Number(header.match(/element vertex (\d+)/)[1]);
  const faces = Number(header.match(/element face (\d+)/)[1]);
  const heights = Array.from({ length: count }, (_, v) => ply.readFloatLE(end + VERTEX_BYTES * v + 8));
  const [low, high] = [heights.reduce((a, b) => Math.min(a, b)), heights.reduce((a, b) => Math.max(a, b))];
  const limit = low + KEPT * (high - low);
  const begin = end + VERTEX_BYTES * count;
  const kept = [];
  for (let f = 0; f < faces; ++f) {
    const face = ply.subarray(begin + FACE_BYTES * f, begin + FACE_BYTES * (f + 1));
    if ([1, 5, 9].every((at) => heights[face.readInt32LE(at)] < limit)) kept.push(face);
  }
  return Buffer.concat([Buffer.from(header.replace(/element face \d+/, `element face ${kept.length}`)), ply.subarray(end, begin), ...kept]);
}
