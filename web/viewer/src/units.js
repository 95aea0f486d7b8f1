// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Numbers for people.

export function formatBytes(bytes) {
  return `${bytes.toLocaleString('en')} B`;
}

/** Three digits. */
export function formatSize(bytes) {
  if (bytes < 1000) return `${bytes} B`;
  return bytes < 1e6 ? `${formatNumber(bytes / 1000)} kB` : `${formatNumber(bytes / 1e6)} MB`;
}

/** Three digits. */
export function formatNumber(value) {
  if (value === 0) return '0';
  if (!Number.isFinite(value)) return '–';
  const size = Math.abs(value);
  return size >= 1e5 || size < 1e-4 ? value.toExponential(2) : String(Number(value.toPrecision(3)));
}

export function formatPercent(share) {
  return `${formatNumber(100 * share)} %`;
}
