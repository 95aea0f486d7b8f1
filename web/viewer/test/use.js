// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// What a person does with the page.
import { waitUntilDone } from './browser.js';

/** Until what was last asked for is drawn. */
async function frames(page) {
  await page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))));
  await page.waitForFunction(() => document.getElementById('canvas').dataset.picture === 'drawn', { timeout: 60000 });
}

/** Chooses one of a few. */
export function choose(page, id, value) {
  return page.$eval(`input[name="${id}"][value="${value}"]`, (input) => input.click());
}

/** Moves a slider through `places`, as a hand does, and waits for what comes of it. */
export async function slide(page, id, places) {
  await page.evaluate(
    async (id, places) => {
      const slider = document.getElementById(`${id}-slider`);
      for (const place of places) {
        await new Promise((resolve) => setTimeout(resolve, 30));
        slider.value = place;
        slider.dispatchEvent(new Event('input', { bubbles: true }));
      }
      document.body.dataset.state = 'busy'; // the page waits a little before it begins
    },
    id,
    places,
  );
  await waitUntilDone(page);
}

/** `files`: [name, bytes], dropped together. Returns how many milliseconds the page takes until all is done. */
export async function dropFiles(page, files) {
  await page.evaluate(async (files) => {
    const dataTransfer = new DataTransfer();
    for (const [name, base64] of files)
      dataTransfer.items.add(new File([Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0))], name));
    document.body.dataset.state = 'busy';
    await new Promise((resolve) => setTimeout(resolve)); // what a test does before is no task of the page's
    document.body.dispatchEvent(new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true }));
  }, files.map(([name, bytes]) => [name, Buffer.from(bytes).toString('base64')]));
  const begin = performance.now();
  await waitUntilDone(page);
  return performance.now() - begin;
}

export const drop = (page, name, bytes) => dropFiles(page, [[name, bytes]]);

/** How many colours a part of the canvas has; `from`, `to`: shares of its width. */
export async function countColors(page, from = 0, to = 1) {
  await frames(page);
  const box = await page.$eval('#canvas', (canvas) => canvas.getBoundingClientRect().toJSON());
  const clip = { x: box.x + from * box.width, y: box.y + 0.2 * box.height, width: (to - from) * box.width, height: 0.5 * box.height };
  const png = await page.screenshot({ clip, encoding: 'base64' });
  return page.evaluate(async (base64) => {
    const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
    const image = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
    const context = new OffscreenCanvas(image.width, image.height).getContext('2d');
    context.drawImage(image, 0, 0);
    return new Set(new Uint32Array(context.getImageData(0, 0, image.width, image.height).data.buffer)).size;
  }, png);
}

/** Of a picture of the canvas: how many pixels are red, and blue, and the sides of the boxes around them. */
export async function boxesOfColors(page) {
  const png = await picture(page);
  return page.evaluate(async (base64) => {
    const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
    const image = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
    const context = new OffscreenCanvas(image.width, image.height).getContext('2d');
    context.drawImage(image, 0, 0);
    const { data } = context.getImageData(0, 0, image.width, image.height);
    const boxOf = (isIn) => {
      const [columns, rows] = [[], []];
      for (let i = 0; i < data.length; i += 4) {
        if (!isIn(data[i], data[i + 1], data[i + 2])) continue;
        columns.push((i / 4) % image.width);
        rows.push(Math.floor(i / 4 / image.width));
      }
      const side = (values) => values.reduce((most, value) => Math.max(most, value), 0) - values.reduce((least, value) => Math.min(least, value), Infinity);
      return { count: rows.length, width: side(columns), height: side(rows) };
    };
    return { red: boxOf((r, g, b) => r > 2 * g && r > 2 * b), blue: boxOf((r, g, b) => b > 2 * r && b > 2.5 * g) };
  }, png);
}

/** The page's theme is read anew, with this background behind meshes, or the theme's own. */
async function setBackground(page, color) {
  await page.$eval('#stage', (stage, color) => (stage.style.backgroundColor = color), color);
  for (const value of ['dark', 'light']) {
    await page.emulateMediaFeatures([{ name: 'prefers-color-scheme', value }]);
    await frames(page);
  }
}

/**
 * Pixels with the mesh all around them that have a part of the background, in a picture of the canvas: what is seen through holes, or
 * through cracks between parts, thinner than a pixel too. Meanwhile the background is magenta, which no mesh here has anything of. The
 * page has the light theme.
 */
export async function countHoles(page) {
  await setBackground(page, 'rgb(255, 0, 255)');
  const png = await picture(page);
  await setBackground(page, '');
  return page.evaluate(async (base64) => {
    const bytes = Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));
    const image = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
    const { width, height } = image;
    const context = new OffscreenCanvas(width, height).getContext('2d');
    context.drawImage(image, 0, 0);
    const { data } = context.getImageData(0, 0, width, height);
    const isEmpty = new Uint8Array(width * height);
    for (let i = 0; i < isEmpty.length; ++i) isEmpty[i] = Math.min(data[4 * i], data[4 * i + 2]) - data[4 * i + 1] > 10 ? 1 : 0;
    // From the picture's border inwards, by corners too: edges of the mesh have steps.
    const open = [];
    for (let x = 0; x < width; ++x) open.push(x, (height - 1) * width + x);
    for (let y = 0; y < height; ++y) open.push(y * width, y * width + width - 1);
    while (open.length > 0) {
      const at = open.pop();
      if (!isEmpty[at]) continue;
      isEmpty[at] = 0;
      const [left, right] = [at % width > 0 ? 1 : 0, (at + 1) % width > 0 ? 1 : 0];
      for (const row of [at - width, at, at + width]) if (row >= 0 && row < isEmpty.length) for (let to = row - left; to <= row + right; ++to) open.push(to);
    }
    return isEmpty.reduce((sum, one) => sum + one, 0);
  }, png);
}

/** Of the canvas, PNG in base64, when the graphics card has drawn what it was last given. */
export async function picture(page) {
  await frames(page);
  return (await page.$('#canvas')).screenshot({ encoding: 'base64' });
}

export const textOf = (page, id) => page.$eval(`#${id}`, (element) => element.textContent);

/** Bytes that the page shows for the whole stream. */
export async function shownBytes(page) {
  const text = await page.$eval('#bytes tbody tr:last-child td', (cell) => cell.textContent);
  return Number(text.replaceAll(/\D/g, ''));
}

/** From now on; longestTask() then tells how long the page was not there at most. */
export function watchTasks(page) {
  return page.evaluate(() => {
    window.longest = 0;
    window.tasks = new PerformanceObserver((list) => {
      for (const { duration } of list.getEntries()) window.longest = Math.max(window.longest, duration);
    });
    window.tasks.observe({ type: 'longtask' });
  });
}

/** Milliseconds; tasks under 50 count as 0. */
export function longestTask(page) {
  return page.evaluate(async () => {
    await new Promise((resolve) => setTimeout(resolve, 200));
    window.tasks.disconnect();
    return window.longest;
  });
}
