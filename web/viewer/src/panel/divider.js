// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// The border of the split view, by pointer and keys.

const STEP = 0.02;

/** `onMove`: gets the share of the width that is left of it. */
export function makeDivider(divider, onMove) {
  let share = 0.5;
  const move = (next) => {
    share = Math.min(1, Math.max(0, next));
    divider.style.left = `${100 * share}%`;
    divider.setAttribute('aria-valuenow', Math.round(100 * share));
    onMove(share);
  };
  divider.addEventListener('pointerdown', (event) => divider.setPointerCapture(event.pointerId));
  divider.addEventListener('pointermove', (event) => {
    if (!divider.hasPointerCapture(event.pointerId)) return;
    const { left, width } = divider.parentElement.getBoundingClientRect();
    move((event.clientX - left) / width);
  });
  divider.addEventListener('keydown', ({ key }) => {
    if (key === 'ArrowLeft') move(share - STEP);
    else if (key === 'ArrowRight') move(share + STEP);
    else if (key === 'Home') move(0);
    else if (key === 'End') move(1);
  });
  move(share);
}
