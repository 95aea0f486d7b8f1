// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Examples as streams, which the build makes with the encoder's default settings and the page finds beside itself.

/** Differences of the order's numbers: most of them are small and come again. */
export function packOrder(order) {
  return Int32Array.from(order, (number, i) => number - (i > 0 ? order[i - 1] : 0));
}

export function unpackOrder(differences) {
  const order = new Uint32Array(differences.length);
  let last = 0;
  differences.forEach((difference, i) => (order[i] = last += difference));
  return order;
}

async function fetched(name) {
  const response = await fetch(new URL(`./${name}`, import.meta.url));
  if (!response.ok) throw new Error(`${name} could not be fetched: ${response.status} ${response.statusText}`);
  return response;
}

/** { bytes, order } of an example, as of the encoder. */
export async function fetchPrepared(name) {
  const [stream, order] = await Promise.all([fetched(`${name}.dmsh`), fetched(`${name}.order.gz`)]);
  const differences = new Response(order.body.pipeThrough(new DecompressionStream('gzip'))).arrayBuffer();
  return { bytes: new Uint8Array(await stream.arrayBuffer()), order: unpackOrder(new Int32Array(await differences)) };
}
