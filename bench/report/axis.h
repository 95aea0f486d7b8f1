// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Axes of a plot, linear and logarithmic: range, ticks, and where a value lies.
#pragma once

#include <string>
#include <vector>

namespace deltamesh::bench {

struct Tick {
  double value = 0;
  std::string label;  ///< empty: a tick without a number
};

class LinearAxis {
 public:
  /// Covers 0 to `high` (above 0, finite), widened to the next tick.
  LinearAxis(double high, double pixel_low, double pixel_high);

  double place(double value) const;
  /// Five to eleven, all numbered, at multiples of 1, 2 or 5 times a power of ten.
  std::vector<Tick> ticks() const;

 private:
  double step_;
  int steps_;
  double pixel_low_;
  double pixel_high_;
};

class LogAxis {
 public:
  /// Covers `low` to `high` (0 < low <= high, finite), widened to the next 1-to-9 tick on either side, and
  /// lies between two pixels (in either direction).
  LogAxis(double low, double high, double pixel_low, double pixel_high);

  double place(double value) const;
  /// One tick for every 1-to-9 multiple of a power of ten; numbered as densely as stays readable.
  std::vector<Tick> ticks() const;

 private:
  double low_;
  double high_;
  double pixel_low_;
  double pixel_high_;
};

}  // namespace deltamesh::bench
