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
  { id: 'colors', label: 'Colours', unit: '/ 255', min: 0, max: 32, scale: 'linear', start: 0, kind: 'color', whole: true },
  { id: 'uvs', label: 'Texture coordinates', unit: '', min: 0.00002, max: 0.02, scale: 'log', start: 1 / 4096, kind: 'uv' },
];

/** Settings that are one of a few: values with their labels. */
export const CHOICES = {
  geometry: { label: 'Coder', values: { auto: 'The smaller', highpass: 'Highpass', predictive: 'Predictive' } },
  effort: { label: 'Effort', values: { 0: 'Least', 1: 'Usual', 2: 'Most' } },
  view: { label: 'Layout', values: { side: 'Side by side', split: 'Split', original: 'Original', result: 'Result' } },
  shading: { label: 'Shading', values: { smooth: 'Smooth', flat: 'Flat', wire: 'Wireframe' } },
  color: {
    label: 'Colour by',
    values: { none: 'Own colour', signed: 'Signed distance', vde: 'Visual error', normal: 'Normals’ angle' },
  },
  mapColor: { label: 'Parts by', values: { own: 'Own colour', bytes: 'Bytes', error: 'Visual error' } },
};

export const DEFAULTS = {
  example: 'knot',
  vde: null,
  lfe: null,
  maxError: 0.05,
  size: null,
  normals: 0.5,
  colors: 0,
  uvs: 1 / 4096,
  geometry: 'auto',
  effort: '1',
  view: 'side',
  shading: 'smooth',
  color: 'none',
  mapColor: 'own',
};

/** A change of these needs another stream. */
export const ENCODING = [...BOUNDS.map(({ id }) => id), 'geometry', 'effort'];

/** For the link: what differs from the defaults. */
export function toHash(settings) {
  const different = Object.entries(settings).filter(([key, value]) => value !== DEFAULTS[key]);
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
  const settings = { ...DEFAULTS };
  const example = given.get('example');
  if (example && /^[a-z]+$/.test(example)) settings.example = example;
  for (const bound of BOUNDS) {
    const value = given.has(bound.id) ? readBound(bound, given.get(bound.id)) : undefined;
    if (value !== undefined) settings[bound.id] = value;
  }
  for (const [id, { values }] of Object.entries(CHOICES)) {
    const value = given.get(id);
    if (value !== null && Object.hasOwn(values, value)) settings[id] = value;
  }
  return settings;
}

/** EncodeOptions of @deltamesh/encoder. */
export function encodeOptions(settings) {
  const share = (value) => (value === null ? undefined : { value, unit: 'diagonal' });
  return {
    vde: share(settings.vde),
    lfe: share(settings.lfe),
    maxError: share(settings.maxError),
    targetBytes: settings.size ?? undefined,
    normalError: settings.normals,
    colorError: settings.colors,
    uvError: settings.uvs,
    geometry: settings.geometry,
    effort: Number(settings.effort),
  };
}
