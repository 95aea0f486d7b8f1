// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// A .gltf file with buffers that are files of their own: they become a part of it. For workers.

const isElsewhere = ({ uri }) => uri !== undefined && !uri.startsWith('data:');

function parse(buffer) {
  try {
    return JSON.parse(new TextDecoder().decode(buffer));
  } catch {
    throw new Error('it is neither a GLB file nor JSON');
  }
}

/** `others`: files, among which buffers are found by their names. Returns what GLTFLoader parses without asking for anything else. */
export function withOtherFiles(buffer, others) {
  if (new TextDecoder('latin1').decode(buffer.slice(0, 4)) === 'glTF') return buffer;
  const json = parse(buffer);
  for (const needed of (json.buffers ?? []).filter(isElsewhere)) {
    const name = decodeURIComponent(needed.uri).split('/').pop();
    const file = others.find((other) => other.name === name);
    if (!file) throw new Error(`its buffer ${name} is a file of its own: choose or drop both together`);
    needed.uri = new FileReaderSync().readAsDataURL(file);
  }
  return new TextEncoder().encode(JSON.stringify(json)).buffer;
}
