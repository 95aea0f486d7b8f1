// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Bytes against error beside Draco and meshoptimizer, as a drawing that is readable in light and dark.
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';

import { DeltameshError, createDecoder } from '@deltamesh/decoder';
import { createEncoder } from '@deltamesh/encoder';
import createDracoModule from 'draco3d/draco_encoder_nodejs.js';

import { encodeAt } from '../src/peers/draco.js';
import { meshoptPoints } from '../src/peers/meshopt.js';
import { requestOf } from '../src/peers/request.js';

const [WIDTH, HEIGHT, LEFT, RIGHT, TOP, BOTTOM] = [880, 380, 70, 150, 24, 58];
/** Largest errors, percent of the diagonal. */
const BOUNDS = [0.4, 0.2, 0.1, 0.05, 0.025, 0.0125];
const BITS = [8, 9, 10, 11, 12, 13, 14];

function check(result) {
  if (result instanceof DeltameshError) throw result;
  return result;
}

/** By codec: { share, bits }: the largest error, percent of the diagonal, and bits for each vertex. Faces and positions alone. */
export async function pointsOf(mesh, diagonal) {
  const [encoder, decoder] = await Promise.all([createEncoder(), createDecoder()]);
  const plain = { ...mesh, groups: null, attributes: [] };
  const place = ({ error, bytes }) => ({ share: (100 * error) / diagonal, bits: (8 * bytes) / (mesh.positions.length / 3) });
  const own = [];
  const meshopt = [];
  for (const value of BOUNDS) {
    const { bytes } = check(encoder.encode(plain, { maxError: { value, unit: 'diagonal' } }));
    const info = check(decoder.inspect(bytes));
    own.push(place({ error: info.quality.maxError, bytes: bytes.length }));
    const [, same] = await meshoptPoints(requestOf(plain, info, bytes.length));
    meshopt.push(place({ error: same.error, bytes: same.deflated }));
  }
  const wasm = createRequire(import.meta.url).resolve('draco3d/draco_encoder.wasm');
  const draco = await createDracoModule({ wasmBinary: readFileSync(wasm) });
  const request = { positions: mesh.positions, indices: mesh.indices, attributes: [] };
  return { deltamesh: own, Draco: BITS.map((bits) => place(encodeAt(draco, request, bits))), 'meshoptimizer, deflated': meshopt };
}

const ticks = (low, high, values) => values.filter((value) => value >= low && value <= high);

/** `series`: of pointsOf(). */
export function drawCurve(series, title) {
  const all = Object.values(series).flat();
  const [low, high] = [0.01, 0.5];
  const most = 10 * Math.ceil(Math.max(...all.filter(({ share }) => share >= low).map(({ bits }) => bits)) / 10);
  const x = (share) => LEFT + ((WIDTH - LEFT - RIGHT) * Math.log(share / low)) / Math.log(high / low);
  const y = (bits) => HEIGHT - BOTTOM - ((HEIGHT - BOTTOM - TOP) * bits) / most;
  const grid = [
    ...ticks(low, high, [0.01, 0.02, 0.05, 0.1, 0.2, 0.5]).map(
      (v) => `<path class="g" d="M${x(v)} ${TOP}V${HEIGHT - BOTTOM}"/><text x="${x(v)}" y="${HEIGHT - BOTTOM + 18}" text-anchor="middle">${v} %</text>`,
    ),
    ...Array.from({ length: most / 10 + 1 }, (_, i) => 10 * i).map(
      (v) => `<path class="g" d="M${LEFT} ${y(v)}H${WIDTH - RIGHT}"/><text x="${LEFT - 8}" y="${y(v) + 4}" text-anchor="end">${v}</text>`,
    ),
  ];
  const lines = Object.entries(series).map(([name, points], i) => {
    const shown = points.filter(({ share }) => share >= low && share <= high).sort((a, b) => a.share - b.share);
    const places = shown.map(({ share, bits }) => `${x(share).toFixed(1)},${y(bits).toFixed(1)}`);
    const [end, last] = [places.at(-1).split(','), shown.length - 1];
    const dots = places.map((place) => `<circle class="d${i}" cx="${place.split(',')[0]}" cy="${place.split(',')[1]}" r="${i === 0 ? 5 : 3.5}"/>`);
    return `<polyline class="l${i}" points="${places.join(' ')}"/>${dots.join('')}<text class="n${i}" x="${Number(end[0]) + 12}" y="${Number(end[1]) + (last < 0 ? 0 : 4)}">${name}</text>`;
  });
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${WIDTH} ${HEIGHT}" role="img" aria-label="${title}">
<style>
text { font: 13px system-ui, sans-serif; fill: #51606f }
.g { stroke: #8896a5; stroke-opacity: .3 }
polyline { fill: none; stroke-width: 2; stroke: #7a8794 }
circle { fill: #7a8794 }
.l0 { stroke: #0b5cad; stroke-width: 3 } .d0 { fill: #0b5cad } .n0 { fill: #0b5cad; font-weight: 700 }
.l2 { stroke-dasharray: 6 4 }
@media (prefers-color-scheme: dark) {
text { fill: #a3b1bf } .l0 { stroke: #6db3f5 } .d0, .n0 { fill: #6db3f5 } polyline { stroke: #8fa0b0 } circle { fill: #8fa0b0 }
.l0 { stroke: #6db3f5 } .d0 { fill: #6db3f5 }
}
</style>
${grid.join('\n')}
${lines.join('\n')}
<text x="${LEFT}" y="${TOP - 8}">bits per vertex, faces and positions</text>
<text x="${(LEFT + WIDTH - RIGHT) / 2}" y="${HEIGHT - 14}" text-anchor="middle">largest error, of the bounding box’ diagonal: ${title}</text>
</svg>
`;
}
