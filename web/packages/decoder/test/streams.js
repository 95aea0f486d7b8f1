// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Streams to test with, and the native decoder's answers.
import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync, readdirSync } from 'node:fs';

const root = new URL('../../../../', import.meta.url).pathname;

/** Golden streams, and those that scripts/check-web makes. */
export function streamPaths() {
  const folders = ['tests/golden', 'build/web/streams'].map((folder) => root + folder).filter(existsSync);
  return folders.flatMap((folder) =>
    readdirSync(folder).filter((name) => name.endsWith('.dmsh')).map((name) => `${folder}/${name}`),
  );
}

export function goldenStreams() {
  return streamPaths().filter((path) => path.includes('/golden/')).map((path) => ({ path, bytes: readFileSync(path) }));
}

/** Streams that break one rule each, with its tag. */
export function invalidStreams() {
  const folder = `${root}tests/golden/invalid`;
  return readdirSync(folder).map((name) => ({ name, rule: name.split('.')[0], bytes: readFileSync(`${folder}/${name}`) }));
}

/** FNV-1a of the arrays' bytes, as tests/bits/hash.h has it. */
export function hashOf(arrays) {
  let low = 0x84222325;
  let high = 0xcbf29ce4;
  for (const array of arrays) {
    for (const byte of new Uint8Array(array.buffer, array.byteOffset, array.byteLength)) {
      low = (low ^ byte) >>> 0;
      const product = low * 0x1b3;
      high = (high * 0x1b3 + Math.floor(product / 2 ** 32) + (low << 8)) >>> 0;
      low = product >>> 0;
    }
  }
  return high.toString(16).padStart(8, '0') + low.toString(16).padStart(8, '0');
}

/** What a program of tests/bits prints: hashes by what they are of; null where that is not built. */
function hashesBy(name, given) {
  const program = `${root}build/release/tests/bits/${name}`;
  if (!existsSync(program)) return null;
  const lines = execFileSync(program, given, { encoding: 'utf8' }).trim().split('\n');
  return new Map(lines.map((line) => [line.slice(17), line.slice(0, 16)]));
}

/** Path to hash, by the native decoder. */
export function nativeHashes(paths) {
  return hashesBy('decode_hash', ['1', ...paths]);
}

/** "PATH, way NUMBER" to hash, by the native encoder: of the stream's mesh, encoded in a way of encode_hash.cpp's. */
export function nativeEncodedHashes(paths) {
  return hashesBy('encode_hash', paths);
}

export function meshHash(mesh) {
  return hashOf([mesh.indices, mesh.positions, ...mesh.attributes.map((attribute) => attribute.values)]);
}
