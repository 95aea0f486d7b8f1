// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// What the page can be told, its defaults, and how a link holds it.

/**
 * A bound that a slider sets; null where it is off. `scale`: of the slider, 'log' or 'linear'. `kind`: an attribute that the mesh
 * must have for the bound to matter.
 */
export const BOUNDS = [
  { id: 'vde', label: 'Visual error (VDE)', unit: '%', min: 0.0005, max: 1, scale: 'log', start: 0.02, optional: true },
  { id: 'lfe', label: 'Positional error (LFE)', unit: '%', min: 0.0005, max: 1, scale: 'log', start: 0.02, optional: true },
  { id: 'maxError', label: 'Largest error', unit: '%', min: 0.001, max: 2, scale: 'log', start: 0.05, optional: true },
  { id: 'size', label: 'Size', unit: 'bytes', min: 500, max: 5e6, scale: 'log', start: 20000, optional: true, whole: true },
  { id: 'normals', label: 'Normals', unit: '°', min: 0.05, max: 15, scale: 'log', start: 0.5, kind: 'normal' },
  { id: 'colors', label: 'Colours, mean error', unit: 'dB', min: 24, max: 60, scale: 'linear', start: 41, kind: 'color', optional: true, whole: true },
  { id: 'uvs', label: 'Texture coordinates', unit: '', min: 0.00002, max: 0.02, scale: 'log', start: 1 / 4096, kind: 'uv' },
];

/**
 * What people ask for, as bounds; `words`: what is said of the result, after its size. Looking the same is what the encoder does by
 * itself: 41 dB of colours that are a photograph's, and labels exact.
 */
export const PRESETS = {
  same: { words: 'and you cannot see it', bounds: { maxError: null, normals: 0.5, colors: null, uvs: 1 / 4096 } },
  small: { words: 'and you have to search for it', bounds: { maxError: 0.1, normals: 2, colors: 38, uvs: 1 / 1024 } },
  tiny: { words: 'and it is still the same thing', bounds: { maxError: 0.4, normals: 6, colors: 33, uvs: 1 / 512 } },
  exact: { words: 'and not one bit is lost', bounds: { maxError: null, normals: 0.5, colors: null, uvs: 1 / 4096 } },
};
const NO_BOUNDS = { vde: null, lfe: null, size: null };

/** The settings of a preset; `own` has those that there are. */
export function withPreset(settings, preset) {
  return { ...settings, preset, ...(PRESETS[preset] ? { ...NO_BOUNDS, ...PRESETS[preset].bounds } : {}) };
}

/** After a person has chosen `value` for a setting; a bound of one's own is no preset's. */
export function changed(settings, id, value) {
  if (id === 'preset') return withPreset(settings, value);
  const isBound = BOUNDS.some((bound) => bound.id === id);
  return { ...settings, [id]: value, ...(isBound ? { preset: 'own' } : {}) };
}

/** Settings that are one of a few: values with their labels. */
export const CHOICES = {
  preset: { label: 'The result is', values: { same: 'Looks the same', small: 'Small', tiny: 'Tiny', exact: 'Exact', own: 'My bounds' } },
  geometry: { label: 'Coder', values: { auto: 'The smaller', highpass: 'Highpass', predictive: 'Predictive' } },
  effort: { label: 'Effort', values: { 0: 'Least', 1: 'Usual', 2: 'Most' } },
  view: { label: 'Layout', values: { side: 'Side by side', split: 'Split', original: 'Original', result: 'Result' } },
  look: { label: 'Look', values: { own: 'Its own', clay: 'Clay' } },
  up: { label: 'Up', values: { file: 'As the file', y: 'Y', z: 'Z' } },
  shading: { label: 'Shading', values: { smooth: 'Smooth', flat: 'Flat', wire: 'Wireframe' } },
  color: {
    label: 'Colour by',
    values: { none: 'Own colour', signed: 'Signed distance', vde: 'Visual error', normal: 'Normals’ angle', tint: 'Colours’ error' },
  },
  mapColor: { label: 'Parts by', values: { own: 'Own colour', bytes: 'Bytes', error: 'Visual error' } },
};

export const DEFAULTS = {
  example: 'room',
  preset: 'same',
  ...NO_BOUNDS,
  ...PRESETS.same.bounds,
  geometry: 'auto',
  effort: '1',
  view: 'split',
  look: 'own',
  up: 'file',
  shading: 'smooth',
  color: 'none',
  mapColor: 'own',
};

/** A change of these needs another stream. */
export const ENCODING = ['preset', ...BOUNDS.map(({ id }) => id), 'geometry', 'effort'];

/** Whether streams that are made beforehand are what is asked for. */
export const asPrepared = (settings) => ENCODING.every((key) => settings[key] === DEFAULTS[key]);

const isBound = (key) => BOUNDS.some(({ id }) => id === key);

/** For the link: what differs from the defaults; of a preset its name alone. */
export function toHash(settings) {
  const isTold = (key) => settings.preset === 'own' || !isBound(key);
  const different = Object.entries(settings).filter(([key, value]) => isTold(key) && value !== DEFAULTS[key]);
  return new URLSearchParams(different.map(([key, value]) => [key, value ?? 'off'])).toString();
}

function readBound({ min, max, optional }, text) {
  if (optional && text === 'off') return null;
  const value = Number(text);
  return text !== '' && value >= min && value <= max ? value : undefined;
}

/** What is not understood keeps its default. */
export function fromHash(hash) {
  const given = new URLSearchParams(hash.replace(/^#/, ''));
  let settings = { ...DEFAULTS };
  const example = given.get('example');
  if (example && /^[a-z]+$/.test(example)) settings.example = example;
  for (const [id, { values }] of Object.entries(CHOICES)) {
    const value = given.get(id);
    if (value !== null && Object.hasOwn(values, value)) settings[id] = value;
  }
  settings = withPreset(settings, settings.preset);
  for (const bound of BOUNDS) {
    const value = given.has(bound.id) ? readBound(bound, given.get(bound.id)) : undefined;
    if (value !== undefined) Object.assign(settings, { [bound.id]: value, preset: 'own' });
  }
  return settings;
}

/** EncodeOptions of @deltamesh/encoder. */
export function encodeOptions(settings) {
  const share = (value) => (value === null ? undefined : { value, unit: 'diagonal' });
  // Of attributes: within a size, their errors grow with those of positions, unless some are asked for.
  const asked = (key) => (settings.size !== null && settings[key] === DEFAULTS[key] ? undefined : settings[key]);
  const colors = asked('colors') ?? null;
  return {
    lossless: settings.preset === 'exact',
    vde: share(settings.vde),
    lfe: share(settings.lfe),
    maxError: share(settings.maxError),
    targetBytes: settings.size ?? undefined,
    normalError: asked('normals'),
    colorRms: colors === null ? undefined : 255 * 10 ** (-colors / 20),
    uvError: asked('uvs'),
    geometry: settings.geometry,
    effort: Number(settings.effort),
  };
}
