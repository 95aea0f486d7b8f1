// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors

/** A share of what a screen shows (sRGB), 0 to 1, as linear light. */
export const toLinear = (value) => (value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4);
