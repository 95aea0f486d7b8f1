// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// How long the page takes: the first picture, which is a still one, and that of the canvas, the result of a large mesh, and the longest task of the page (npm run times). For a machine
// that does nothing else, so no gate.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';

import { EXAMPLES } from '../src/mesh/examples.js';
import { writeGlb } from '../src/mesh/write-glb.js';
import { hasChromium, openPage, waitUntilDone } from '../test/browser.js';
import { drop, longestTask, slide, textOf, watchTasks } from '../test/use.js';

const skip = hasChromium ? false : 'Chromium is not installed (scripts/setup web)';
const ATTEMPTS = 3;
const FIRST_PICTURE = 1500;
const DRAWN = 3000;
const RESULT = 2000;
const TASK = 100;
const MILLION = 20000;

let open;
before(async () => {
  if (!hasChromium) return;
  open = await openPage({ hash: '#example=terrain' });
  await waitUntilDone(open.page);
});
after(() => open?.close());

function judge(t, what, time, asked) {
  t.diagnostic(`${what}: ${time.toFixed(0)} ms, asked are ${asked}`);
  assert.ok(time <= asked, what);
}

const middle = (times) => times.sort((a, b) => a - b)[(ATTEMPTS - 1) / 2];

async function median(measure) {
  const times = [];
  while (times.length < ATTEMPTS) times.push(await measure());
  return middle(times);
}

/** When the still picture is seen, and the first one of the canvas; and the longest task until then. */
async function firstPictures() {
  const { page, close } = await openPage({
    before: () => {
      window.longest = 0;
      const follow = (type, observe) => new PerformanceObserver((list) => list.getEntries().forEach(observe)).observe({ type, buffered: true });
      follow('element', ({ renderTime }) => (window.still = renderTime));
      follow('longtask', ({ duration }) => (window.longest = Math.max(window.longest, duration)));
    },
  });
  await page.waitForFunction(() => performance.getEntriesByName('first picture').length > 0, { timeout: 60000 });
  const times = await page.evaluate(() => [window.still, performance.getEntriesByName('first picture')[0].startTime, window.longest]);
  const summary = await textOf(page, 'summary');
  await close();
  assert.match(summary, /compressed beforehand/);
  return times;
}

test('tasks that are too long are seen', { skip }, async () => {
  await watchTasks(open.page);
  // Tasks of the page alone count, not what evaluate() runs before it waits.
  await open.page.evaluate(async () => {
    await new Promise((resolve) => setTimeout(resolve));
    const end = performance.now() + 150;
    while (performance.now() < end);
  });
  assert.ok((await longestTask(open.page)) >= 150);
});

test('the first picture is there in time', { skip }, async (t) => {
  const all = [];
  while (all.length < ATTEMPTS) all.push(await firstPictures());
  const [still, drawn, longest] = [0, 1, 2].map((k) => middle(all.map((times) => times[k])));
  judge(t, 'first picture', still, FIRST_PICTURE);
  judge(t, 'first picture of the canvas', drawn, DRAWN);
  judge(t, 'longest task until then', longest, TASK);
});

const knotOf = (rows, columns) => writeGlb({ origin: [0, 0, 0], groups: null, ...EXAMPLES.knot.make(rows, columns) });

/** Milliseconds until the headline tells the result. */
async function resultOf(name, glb) {
  await open.page.evaluate(() => {
    const line = document.getElementById('headline');
    window.result = new Promise((resolve) => {
      const observer = new MutationObserver(() => {
        if (line.textContent === '') return;
        observer.disconnect();
        resolve(performance.now());
      });
      observer.observe(line, { childList: true, characterData: true, subtree: true });
    });
    document.addEventListener('drop', () => (window.dropped = performance.now()), { capture: true, once: true });
  });
  await drop(open.page, name, glb);
  return open.page.evaluate(async () => (await window.result) - window.dropped);
}

test('the result of 100,000 vertices is there in time, and no task is long', { skip }, async (t) => {
  const glb = knotOf(1000, 100);
  await watchTasks(open.page);
  const time = await median(() => resultOf('large.glb', glb));
  const longest = await longestTask(open.page);
  judge(t, 'result', time, RESULT);
  judge(t, 'longest task', longest, TASK);
  await watchTasks(open.page);
  await slide(open.page, 'maxError', [110, 112, 115, 120, 126]);
  judge(t, 'longest task while sliders move', await longestTask(open.page), TASK);
});

test('a million vertices work', { skip }, async (t) => {
  const time = await resultOf('million.glb', knotOf(4000, 250));
  assert.equal(await textOf(open.page, 'error'), '');
  assert.match(await textOf(open.page, 'mesh-name'), /1,000,000 vertices/);
  judge(t, 'result', time, MILLION);
});
