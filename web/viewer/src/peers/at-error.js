// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
// Sizes at an error that lies between those that a codec can have.

/** Between the two `points` around it, { error, [key] } from coarse to fine: a line where both are logarithms. */
export function sizeAt(points, error, key = 'bytes') {
  const above = points.findIndex((point, i) => points[i + 1] && point.error >= error && points[i + 1].error <= error);
  if (above < 0) return points.reduce((best, point) => (Math.abs(Math.log(point.error / error)) < Math.abs(Math.log(best.error / error)) ? point : best))[key];
  const [coarse, fine] = [points[above], points[above + 1]];
  if (coarse.error === fine.error) return coarse[key];
  const share = Math.log(error / coarse.error) / Math.log(fine.error / coarse.error);
  return Math.round(coarse[key] * (fine[key] / coarse[key]) ** share);
}
