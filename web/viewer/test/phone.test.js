// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// The page on a phone: nothing is wider than it, what has the focus is seen, and fingers move the border and the camera.
import assert from 'node:assert/strict';
import { test } from 'node:test';

import { hasChromium, openPage, waitUntilDone } from './browser.js';
import { picture } from './use.js';

const skip = hasChromium ? false : 'Chromium is not installed (scripts/setup web)';
const SIZES = { upright: { width: 390, height: 844 }, lying: { width: 844, height: 390 } };

for (const [name, size] of Object.entries(SIZES)) {
  test(`on a phone, ${name}`, { skip }, async () => {
    const { page, problems, close } = await openPage({ hash: '#example=terrain&effort=0', ...size, isPhone: true });
    await waitUntilDone(page);
    await page.$eval('#details', (details) => (details.open = true));
    assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
    const { x, y, width, height } = await page.$eval('#stage', (stage) => stage.getBoundingClientRect().toJSON());
    const drag = async (from, to) => {
      await page.touchscreen.touchStart(x + from * width, y + 0.5 * height);
      for (let step = 1; step <= 4; ++step) await page.touchscreen.touchMove(x + (from + (step / 4) * (to - from)) * width, y + 0.5 * height);
      await page.touchscreen.touchEnd();
    };
    await drag(0.5, 0.8);
    assert.ok(Math.abs((await page.$eval('#divider', (divider) => Number(divider.getAttribute('aria-valuenow')))) - 80) <= 3);
    const before = await picture(page);
    await drag(0.2, 0.4);
    assert.notEqual(await picture(page), before);
    const isHidden = () => {
      const [focus, stage] = [document.activeElement, document.getElementById('stage')].map((element) => element.getBoundingClientRect());
      const isBelow = document.getElementById('panel').contains(document.activeElement) && getComputedStyle(document.getElementById('stage')).position === 'sticky';
      return isBelow && focus.top < stage.bottom - 1;
    };
    const press = async (count) => {
      for (let i = 0; i < count; ++i) {
        await page.keyboard.press('Tab');
        assert.equal(await page.evaluate(isHidden), false, await page.evaluate(() => document.activeElement.outerHTML));
      }
    };
    await press(60);
    await page.keyboard.down('Shift');
    await press(60);
    await page.keyboard.up('Shift');
    assert.deepEqual(problems, []);
    await close();
  });
}
