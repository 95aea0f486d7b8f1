// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Bytes against the largest error, both in logarithms: lines of others, and the results so far with the one in use.
import { formatNumber, formatSize } from '../units.js';

const [WIDTH, HEIGHT, LEFT, BOTTOM, TOP] = [330, 190, 52, 34, 8];
const MARGIN = 1.15;

function element(name, attributes, text) {
  const made = document.createElementNS('http://www.w3.org/2000/svg', name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  if (text !== undefined) made.textContent = text;
  return made;
}

/** Places of values on an axis from `from` to `to`. */
function axis(values, from, to) {
  const [low, high] = [Math.min(...values) / MARGIN, Math.max(...values) * MARGIN];
  return { low, high, at: (value) => from + ((to - from) * Math.log(value / low)) / Math.log(high / low) };
}

/** `all`: { name, points: { error, bytes }, isOwn, inUse }. What is exact, as a square on a lattice, has no place here. */
export function drawChart(svg, all) {
  const placed = all.map((each) => ({ ...each, points: each.points.filter(({ error }) => error > 0) }));
  const series = placed.filter(({ points }) => points.length > 0);
  const points = series.flatMap((each) => each.points);
  const x = axis(points.map(({ error }) => error), LEFT, WIDTH - 8);
  const y = axis(points.map(({ bytes }) => bytes), HEIGHT - BOTTOM, TOP);
  const place = ({ error, bytes }) => [x.at(error).toFixed(1), y.at(bytes).toFixed(1)];
  const frame = element('path', { class: 'axis', d: `M${LEFT} ${TOP}V${HEIGHT - BOTTOM}H${WIDTH - 8}` });
  const texts = [
    [LEFT - 5, TOP + 9, 'end', formatSize(y.high)], [LEFT - 5, HEIGHT - BOTTOM, 'end', formatSize(y.low)],
    [LEFT, HEIGHT - BOTTOM + 14, 'start', formatNumber(x.low)], [WIDTH - 8, HEIGHT - BOTTOM + 14, 'end', formatNumber(x.high)],
    [(LEFT + WIDTH) / 2, HEIGHT - 4, 'middle', 'largest error, model units'],
  ].map(([tx, ty, anchor, text]) => element('text', { x: tx, y: ty, 'text-anchor': anchor }, text));
  const marks = series.flatMap(({ name, points, isOwn, inUse }, i) => {
    const sorted = [...points].sort((a, b) => a.error - b.error);
    const line = element('polyline', { class: `line line-${i}`, points: sorted.map((point) => place(point).join()).join(' ') });
    const dots = sorted.map((point) => {
      const [cx, cy] = place(point);
      const dot = element('circle', { class: `dot dot-${i}`, cx, cy, r: point === inUse ? 6 : 3 });
      dot.append(element('title', {}, `${name}: ${formatSize(point.bytes)} at ${formatNumber(point.error)}`));
      return dot;
    });
    const [lx, ly] = place(isOwn ? inUse : sorted[0]);
    const label = element('text', { x: Number(lx) + 8, y: Number(ly) + (isOwn ? -9 : -7), class: `name name-${i}` }, name);
    return [line, ...dots, label];
  });
  svg.setAttribute('viewBox', `0 0 ${WIDTH} ${HEIGHT}`);
  svg.replaceChildren(frame, ...texts, ...marks);
}
