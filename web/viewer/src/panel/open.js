// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Files from the buttons or dropped on the page, and folders.
import { filesOfFolders } from '../map/map-files.js';

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

export function download(bytes, name, type) {
  const url = URL.createObjectURL(new Blob([bytes], { type }));
  const link = Object.assign(document.createElement('a'), { href: url, download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), 10000);
}
