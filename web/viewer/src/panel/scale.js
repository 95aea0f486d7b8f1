// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// The scale of the heat map.
import { formatNumber } from '../units.js';

export function showScale(figure, heat, limit) {
  figure.hidden = !heat;
  if (!heat) return;
  const find = (id) => figure.querySelector(`#scale-${id}`);
  find('name').textContent = `${heat.name}, ${heat.unit}`;
  find('bar').style.background = `linear-gradient(to right, ${heat.colors.join(', ')})`;
  find('low').textContent = heat.isSigned ? `−${formatNumber(limit)}` : '0';
  find('middle').textContent = heat.isSigned ? '0' : formatNumber(limit / 2);
  find('high').textContent = formatNumber(limit);
}
