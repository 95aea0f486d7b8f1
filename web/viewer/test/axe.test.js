// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// axe-core finds no serious fault of the page: in light and dark, on a phone, with all of it open.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';

import { hasChromium, openPage, waitUntilDone } from './browser.js';

const skip = hasChromium ? false : 'Chromium is not installed (scripts/setup web)';
const axe = readFileSync(new URL(import.meta.resolve('axe-core')), 'utf8');
const STATES = {
  light: { hash: '#example=terrain&effort=0' },
  dark: { hash: '#example=terrain&effort=0&color=signed', dark: true },
  phone: { hash: '#example=terrain&effort=0', width: 390, height: 844, isPhone: true },
};

for (const [name, options] of Object.entries(STATES)) {
  test(`no serious fault: ${name}`, { skip }, async () => {
    const { page, close } = await openPage(options);
    await waitUntilDone(page);
    await page.$eval('#details', (details) => (details.open = true));
    await page.evaluate(axe);
    const { violations } = await page.evaluate(() => window.axe.run());
    const serious = violations.filter(({ impact }) => ['serious', 'critical'].includes(impact));
    assert.deepEqual(serious.map(({ id, nodes }) => `${id}: ${nodes.map(({ target }) => target).join()}`), []);
    await close();
  });
}
