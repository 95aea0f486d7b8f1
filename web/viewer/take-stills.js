// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Pictures of what the page shows first, which people see while it is still on its way: by the page itself, where Chromium is.
import { fileURLToPath } from 'node:url';

import { hasChromium, openPage, waitUntilDone } from './test/browser.js';

const THEMES = ['light', 'dark'];
/** Wider than stages are: the camera's field of view is that of the height. */
const [WIDTH, HEIGHT] = [1920, 800];
const ALONE = '#stage { position: fixed; inset: 0; z-index: 9 } #stage > :not(canvas) { visibility: hidden }';

const MARKUP = `<picture id="still"><source srcset="still-dark.webp" media="(prefers-color-scheme: dark)" /><img src="still-light.webp" alt="" elementtiming="still" /></picture>
        <script>if (location.search || location.hash) document.getElementById('still').remove(); // something else is asked for</script>`;

/** Into the page's folder; what index.html needs for them, or nothing. */
export async function takeStills(dist) {
  if (!hasChromium) return '';
  for (const theme of THEMES) {
    const { page, close } = await openPage({ hash: '#view=original', dark: theme === 'dark', width: WIDTH, height: HEIGHT });
    await page.addStyleTag({ content: ALONE });
    await waitUntilDone(page);
    await page.waitForFunction(() => document.getElementById('canvas').dataset.picture === 'drawn', { timeout: 60000 });
    await page.screenshot({ path: fileURLToPath(new URL(`still-${theme}.webp`, dist)), type: 'webp', quality: 80 });
    await close();
  }
  return MARKUP;
}
