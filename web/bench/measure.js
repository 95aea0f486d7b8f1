// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Times of decoding, in node and in browsers.
import { DeltameshError, createDecoder } from '@deltamesh/decoder';

import { openDraco } from './draco.js';

/** Decodes before times count: V8 compiles what is used often once more, on another thread. */
const WARM_UP_MILLISECONDS = 1500;
const LEAST_TURNS = 7;
const MOST_MILLISECONDS = 4000;

/** With the modules that `streams` need, which decode() of a page loads, too. */
async function openDeltamesh(files, streams) {
  const decoder = await createDecoder({ files });
  for (const part of new Set(streams.flatMap((bytes) => decoder.inspect(bytes).modules))) await decoder.load(part);
  return (bytes) => {
    const mesh = decoder.decodeSync(bytes);
    if (mesh instanceof DeltameshError) throw mesh;
    return mesh;
  };
}

/** `modules`: { core, highpass, rare, grid, zstd, draco }, bytes. */
function openCodec(codec, { draco, ...modules }, streams) {
  return codec === 'draco' ? openDraco(draco) : openDeltamesh(modules, streams);
}

function timeOf(decode, streams) {
  const begin = performance.now();
  for (const bytes of streams) decode(bytes);
  return performance.now() - begin;
}

export function median(values) {
  const sorted = values.toSorted((a, b) => a - b);
  return (sorted[(sorted.length - 1) >> 1] + sorted[sorted.length >> 1]) / 2;
}

/** The first decode, and the same from the modules' bytes on, milliseconds. Only the first call in a process means anything. */
export async function cold(codec, modules, streams) {
  const begin = performance.now();
  const first = timeOf(await openCodec(codec, modules, streams), streams);
  return { cold: first, 'cold, with the module': performance.now() - begin };
}

/** Of the modules, after `streams` are decoded, MiB. Only the first call in a process means anything. */
export async function memory(codec, modules, streams) {
  const made = [];
  const { Memory } = WebAssembly;
  WebAssembly.Memory = class extends Memory {
    constructor(descriptor) {
      super(descriptor);
      made.push(this);
    }
  };
  const decode = await openCodec(codec, modules, streams);
  timeOf(decode, streams);
  const bytes = decode.memoryBytes?.() ?? made.reduce((sum, { buffer }) => sum + buffer.byteLength, 0);
  return bytes / 2 ** 20;
}

/** Medians of decodes in turn, milliseconds. `jobs`: by name, { codec, streams }. */
export async function warm(jobs, modules) {
  const own = Object.values(jobs).flatMap(({ codec, streams }) => (codec === 'deltamesh' ? streams : []));
  const codecs = { deltamesh: await openCodec('deltamesh', modules, own), draco: await openCodec('draco', modules) };
  const turn = () => Object.values(jobs).map(({ codec, streams }) => timeOf(codecs[codec], streams));
  for (const begin = performance.now(); performance.now() - begin < WARM_UP_MILLISECONDS; ) {
    turn();
    await new Promise((resolve) => setTimeout(resolve));
  }
  const turns = [];
  for (const begin = performance.now(); turns.length < LEAST_TURNS || performance.now() - begin < MOST_MILLISECONDS; )
    turns.push(turn());
  return Object.fromEntries(Object.keys(jobs).map((name, i) => [name, median(turns.map((times) => times[i]))]));
}
