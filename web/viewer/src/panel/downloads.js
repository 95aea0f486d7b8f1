// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// What people take along: results as files, and the page's link.
import { formatSize } from '../units.js';

function download(bytes, name, type) {
  const url = URL.createObjectURL(new Blob([bytes], { type }));
  const link = Object.assign(document.createElement('a'), { href: url, download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), 10000);
}

/** Materials, textures and animations stay; a size is of one mesh alone, and is not asked for. */
async function downloadPacked(workshop, status, { name, file, options }) {
  status.tell('Packing the file');
  const glb = await workshop.pack(file, { ...options, targetBytes: undefined });
  download(glb, `${name}.packed.glb`, 'model/gltf-binary');
  status.tell(`Packed: ${formatSize(file.size)} → ${formatSize(glb.length)}, materials, textures and animations as they were`, false);
}

async function downloadGlb(workshop, { bytes, name }) {
  download(await workshop.glb(bytes), `${name}.glb`, 'model/gltf-binary');
}

/** `current`: what there is: { bytes, name, file, options }; `file`: a GLB file, or null. */
export function offerDownloads(find, workshop, status, current) {
  find('download-glb').addEventListener('click', () => downloadGlb(workshop, current()).catch((error) => status.fail(error)));
  find('download-packed').addEventListener('click', () => downloadPacked(workshop, status, current()).catch((error) => status.fail(error)));
}

/** The page's link, to the clipboard. Returns where it is. */
export async function copyLink() {
  try {
    await navigator.clipboard.writeText(location.href);
    return 'The link is in the clipboard';
  } catch {
    return 'The link is in the address bar';
  }
}
