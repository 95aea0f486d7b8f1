// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Begins with what is seen first, while the page itself is still on its way.
import { fromHash } from './settings.js';
import { fetchStudio } from './stage/studio-file.js';
import { Workshop, isDrawnBySoftware } from './workshop.js';

const workshop = new Workshop();
const { url, live, map = '0' } = Object.fromEntries(new URLSearchParams(location.search));
const { example } = fromHash(location.hash);
const first = url || live ? null : workshop.example(example);
first?.catch(() => {}); // the page tells of it
try {
  const drawing = Promise.all([isDrawnBySoftware(), fetchStudio()]);
  const { Page } = await import('./page.js');
  const [isSoftware, studio] = await drawing;
  const page = new Page(workshop, { isSoftware, studio });
  window.viewer = { replacePart: (place, bytes) => page.maps.replace(place, bytes) };
  if (live) page.openLive(live, map);
  else if (url) page.openFirst(url);
  else page.openExample(example, first);
} catch (error) {
  const line = document.getElementById('error');
  line.textContent = `The page could not be loaded: ${error.message}`;
  line.hidden = false;
}
