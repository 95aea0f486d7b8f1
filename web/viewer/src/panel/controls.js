// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// The form: a row for each bound, radio buttons for choices.
import { formatNumber } from '../units.js';
import { BOUNDS, CHOICES } from '../settings.js';

const STEPS = 200;

function element(name, properties = {}, ...children) {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...children);
  return made;
}

/** Places of the slider, 0 to STEPS, for values and back. */
function toPlace({ min, max, scale }, value) {
  if (scale === 'linear') return (STEPS * (value - min)) / (max - min);
  return (STEPS * Math.log(value / min)) / Math.log(max / min);
}

function fromPlace({ min, max, scale, whole }, place) {
  const share = place / STEPS;
  const value = scale === 'linear' ? min + share * (max - min) : min * (max / min) ** share;
  return whole ? Math.round(value) : Math.min(max, Math.max(min, Number(value.toPrecision(3))));
}

function boundRow(bound, onChange) {
  const { id, label, unit, min, max, optional, whole, start } = bound;
  const slider = element('input', { type: 'range', id: `${id}-slider`, min: 0, max: STEPS, step: 1 });
  slider.setAttribute('aria-label', `${label}, slider`);
  const number = element('input', { type: 'number', id, min, max, step: whole ? 1 : 'any', required: true });
  const check = optional ? element('input', { type: 'checkbox', id: `${id}-on` }) : null;
  if (check) check.setAttribute('aria-label', `Bound: ${label}`);
  const name = element('label', { htmlFor: id, textContent: label });
  const head = element('div', { className: 'bound-head' }, ...(check ? [check] : []), name, number);
  head.append(element('span', { className: 'unit', textContent: unit }));
  const row = element('div', { className: 'bound' }, head, slider);

  let value = start;
  const show = () => {
    number.value = formatNumber(value);
    slider.value = toPlace(bound, value);
    slider.setAttribute('aria-valuetext', `${formatNumber(value)} ${unit}`);
  };
  const give = (next, isOn = true) => {
    value = next;
    show();
    if (check) check.checked = isOn;
    row.classList.toggle('off', !isOn);
    onChange(id, isOn ? value : null);
  };
  slider.addEventListener('input', () => give(fromPlace(bound, Number(slider.value))));
  number.addEventListener('change', () => {
    if (number.checkValidity()) give(Number(number.value));
    else number.reportValidity();
  });
  check?.addEventListener('change', () => give(value, check.checked));
  return {
    row,
    set(given) {
      value = given ?? value;
      show();
      if (check) check.checked = given !== null;
      row.classList.toggle('off', given === null);
    },
  };
}

function choiceRow(id, onChange) {
  const { label, values } = CHOICES[id];
  const buttons = Object.entries(values).map(([value, text]) => {
    const input = element('input', { type: 'radio', name: id, value });
    input.addEventListener('change', () => onChange(id, value));
    return { input, row: element('label', {}, input, element('span', { textContent: text })) };
  });
  const rows = buttons.map(({ row }) => row);
  const row = element('fieldset', { className: 'choice' }, element('legend', { textContent: label }), ...rows);
  return {
    row,
    set(value) {
      for (const { input } of buttons) input.checked = input.value === value;
    },
  };
}

/** Fills elements of the page. `onChange`: gets a setting's name and its new value. */
export class Controls {
  #rows = {};

  constructor(find, onChange) {
    const [quality, bounds, coder, view] = ['quality', 'bounds', 'coder', 'view'].map(find);
    const add = (place, id, row) => {
      this.#rows[id] = row;
      place.append(row.row);
    };
    add(quality, 'preset', choiceRow('preset', onChange));
    for (const bound of BOUNDS) add(bound.id === 'size' ? quality : bounds, bound.id, boundRow(bound, onChange));
    for (const id of ['geometry', 'effort']) add(coder, id, choiceRow(id, onChange));
    for (const id of ['view', 'look', 'shading', 'color', 'up', 'mapColor']) add(view, id, choiceRow(id, onChange));
  }

  show(settings) {
    for (const [id, row] of Object.entries(this.#rows)) row.set(settings[id]);
  }

  /** A map has no original to compare with, and is not encoded; of one that changes its own colours are shown. */
  showMap(find, isMap, isLive = false) {
    for (const id of ['quality', 'details', 'others', 'copy-link']) find(id).hidden = isMap;
    for (const id of ['label-original', 'label-result', 'divider']) if (isMap) find(id).hidden = true;
    for (const id of ['view', 'color', 'look', 'up']) this.#rows[id].row.hidden = isMap;
    this.#rows.mapColor.row.hidden = !isMap || isLive;
  }

  /** Hides the bounds of attributes that the mesh does not have. */
  showKinds(kinds) {
    for (const { id, kind } of BOUNDS) this.#rows[id].row.hidden = Boolean(kind) && !kinds.has(kind);
  }
}
