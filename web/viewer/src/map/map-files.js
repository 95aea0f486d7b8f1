// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// The files of a map's folder, from a folder that is chosen or dropped.

const MANIFEST = 'map.dmm';

/** `entry`: a FileSystemEntry. */
async function* filesBelow(entry) {
  if (entry.isFile) {
    yield await new Promise((resolve, reject) => entry.file(resolve, reject));
    return;
  }
  const reader = entry.createReader();
  for (;;) {
    const some = await new Promise((resolve, reject) => reader.readEntries(resolve, reject));
    if (some.length === 0) return;
    for (const next of some) yield* filesBelow(next);
  }
}

/** Files of the folders that are dropped; call it before anything is waited for. */
export async function filesOfFolders(dataTransfer) {
  const entries = [...dataTransfer.items].map((item) => item.webkitGetAsEntry?.()).filter((entry) => entry?.isDirectory);
  const files = [];
  for (const entry of entries) for await (const file of filesBelow(entry)) files.push(file);
  return files;
}

/** { manifest, parts: name to file }; null where the files are not those of a map. */
export function mapOf(files) {
  const manifest = files.find(({ name }) => name === MANIFEST);
  return manifest ? { manifest, parts: new Map(files.map((file) => [file.name, file])) } : null;
}
