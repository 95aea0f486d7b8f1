// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// What people do in the page, but for the settings.
import { makeDivider } from './panel/divider.js';
import { copyLink, offerDownloads } from './panel/downloads.js';
import { listExamples, openFiles, openPasted } from './panel/open.js';

/** `page`: a Page; `find`: from an id to an element. */
export function listen(page, find) {
  listExamples(find('example'), (name) => page.openExample(name));
  openFiles({ input: find('file'), folderInput: find('folder'), hint: find('drop-hint') }, {
    onFiles: (files) => page.openFiles(files),
    onFolder: (files) => page.openMap(files),
    onFailure: (error) => page.status.fail(error),
  });
  openPasted({ onFiles: (files) => page.openFiles(files), onUrl: (url) => page.openUrl(url) });
  makeDivider(find('divider'), (share) => page.picture.setSplit(share));
  find('panel').addEventListener('submit', (event) => event.preventDefault());
  find('cancel').addEventListener('click', () => page.cancel());
  offerDownloads(find, page.workshop, page.status, () => page.download);
  find('copy-link').addEventListener('click', async () => {
    page.keepLink();
    find('status').textContent = await copyLink();
  });
  window.addEventListener('hashchange', () => page.followLink());
}
