// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A document of glTF-Transform's as it is written, JSON and resources, to one GLB and back.
const GLB_BUFFER = '@glb.bin';
const MAGIC = 0x46546c67;
const JSON_CHUNK = 0x4e4f534a;
const BINARY_CHUNK = 0x004e4942;

const padded = (length) => Math.ceil(length / 8) * 8;

export function resourceOf({ json, resources }, buffer) {
  return resources[json.buffers[buffer].uri ?? GLB_BUFFER];
}

function concat(parts) {
  const all = new Uint8Array(parts.reduce((length, part) => length + part.length, 0));
  let end = 0;
  for (const part of parts) {
    all.set(part, end);
    end += part.length;
  }
  return all;
}

/** All buffers are one in it, and extensions that are called `unnamed` are not in its lists. */
export function toGlb(document, unnamed) {
  const { json } = document;
  const starts = [];
  const parts = [];
  let length = 0;
  for (let i = 0; i < (json.buffers?.length ?? 0); ++i) {
    const bytes = resourceOf(document, i) ?? new Uint8Array();
    starts.push(length);
    length += padded(bytes.length);
    parts.push(bytes, new Uint8Array(padded(bytes.length) - bytes.length));
  }
  const whole = {
    ...json,
    buffers: length > 0 ? [{ ...json.buffers[0], uri: undefined, byteLength: length }] : [],
    bufferViews: json.bufferViews?.map((view) => ({ ...view, buffer: 0, byteOffset: (view.byteOffset ?? 0) + starts[view.buffer] })),
  };
  for (const list of ['extensionsUsed', 'extensionsRequired']) whole[list] = json[list]?.filter((name) => name !== unnamed);
  const text = new TextEncoder().encode(JSON.stringify(whole));
  const blanks = new Uint8Array(padded(text.length) - text.length).fill(32);
  const total = 28 + text.length + blanks.length + length;
  const header = Uint32Array.of(MAGIC, 2, total, text.length + blanks.length, JSON_CHUNK);
  const bytesOf = (words) => new Uint8Array(words.buffer);
  return concat([bytesOf(header), text, blanks, bytesOf(Uint32Array.of(length, BINARY_CHUNK)), ...parts]);
}

/** Makes the document, in place, that of a GLB, whose buffer has the name of the document's first one. */
export function fromGlb({ json, resources }, glb) {
  const view = new DataView(glb.buffer, glb.byteOffset);
  const end = 20 + view.getUint32(12, true);
  const uri = json.buffers?.[0]?.uri;
  for (const buffer of json.buffers ?? []) delete resources[buffer.uri ?? GLB_BUFFER];
  for (const key of Object.keys(json)) delete json[key];
  Object.assign(json, JSON.parse(new TextDecoder().decode(glb.subarray(20, end))));
  if (!json.buffers?.length) return;
  if (uri !== undefined) json.buffers[0].uri = uri;
  resources[uri ?? GLB_BUFFER] = glb.slice(end + 8, end + 8 + json.buffers[0].byteLength);
}
