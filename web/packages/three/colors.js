// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Colours as three.js takes them: linear.
import { Color, SRGBColorSpace } from 'three';

const color = new Color();
/** As PLYLoader does it: rounded, where colours are integers. */
function convert(value, scale) {
  const { r } = color.setRGB(value / scale, 0, 0, SRGBColorSpace);
  return scale === 1 ? r : Math.round(r * scale);
}

/** Alpha stays as it is. */
export function linearFromSrgb({ values, components }) {
  const scale = { 1: 255, 2: 65535 }[values.BYTES_PER_ELEMENT] ?? 1;
  const known = scale === 1 ? undefined : Array.from({ length: scale + 1 }, (_, value) => convert(value, scale));
  return values.map((value, i) => (i % components === 3 ? value : (known?.[value] ?? convert(value, scale))));
}
