// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Files from the buttons or dropped on the page, and folders.
import { filesOfFolders } from '../map/map-files.js';
import { EXAMPLES } from '../mesh/examples.js';
import { isMeshName } from '../mesh/mesh-names.js';

/** One mesh among files, with the others; or a `failure`, which says why there is none. */
export function oneMeshOf(files) {
  const meshes = files.length === 1 ? files : files.filter(({ name }) => isMeshName(name));
  const [file] = meshes;
  if (meshes.length === 1) return { file, others: files.filter((other) => other !== file) };
  const names = files.map(({ name }) => name).join(', ');
  return { failure: new Error(`${meshes.length === 0 ? 'None of these is a mesh' : 'Open one mesh at a time'}: ${names}`) };
}

/** `onFiles`: gets files that are chosen or dropped together; `onFolder`: those of a folder; `onFailure`: why one cannot be read. */
export function openFiles({ input, folderInput, hint }, { onFiles, onFolder, onFailure }) {
  folderInput.addEventListener('change', () => {
    onFolder([...folderInput.files]);
    folderInput.value = '';
  });
  input.addEventListener('change', () => {
    if (input.files.length > 0) onFiles([...input.files]);
    input.value = '';
  });
  let depth = 0; // of elements that the pointer is in
  const show = (change) => {
    depth = Math.max(0, depth + change);
    hint.hidden = depth === 0;
  };
  document.addEventListener('dragenter', () => show(1));
  document.addEventListener('dragleave', () => show(-1));
  document.addEventListener('dragover', (event) => event.preventDefault());
  document.addEventListener('drop', async (event) => {
    event.preventDefault();
    show(-depth);
    const files = [...event.dataTransfer.files];
    try {
      const inFolders = await filesOfFolders(event.dataTransfer);
      if (inFolders.length > 0) onFolder(inFolders);
      else if (files.length > 0) onFiles(files);
    } catch (error) {
      onFailure(error);
    }
  });
}

/** Files, or a URL, from the clipboard; not where a person types. `onUrl`: gets a URL. */
export function openPasted({ onFiles, onUrl }) {
  document.addEventListener('paste', (event) => {
    if (event.target.matches?.('input, textarea')) return;
    const files = [...event.clipboardData.files];
    const text = event.clipboardData.getData('text/plain').trim();
    if (files.length > 0) onFiles(files);
    else if (/^https?:\/\/\S+$/.test(text)) onUrl(text);
  });
}

/** A file of another place; throws what a person can read. */
export async function fetchFile(url) {
  const name = decodeURIComponent(new URL(url, location.href).pathname.split('/').pop()) || 'file';
  let response;
  try {
    response = await fetch(url);
  } catch {
    throw new Error(`${url} could not be fetched: there is no way to it, or its server does not allow other pages to read it (CORS)`);
  }
  if (!response.ok) throw new Error(`${url} could not be fetched: ${response.status} ${response.statusText}`);
  return new File([await response.arrayBuffer()], name);
}

/** `onChoice`: gets the name of an example. */
export function listExamples(select, onChoice) {
  for (const [name, { label }] of Object.entries(EXAMPLES)) select.add(new Option(label, name));
  const own = new Option('Own file', 'file');
  own.hidden = true;
  select.add(own);
  select.addEventListener('change', () => onChoice(select.value));
}
