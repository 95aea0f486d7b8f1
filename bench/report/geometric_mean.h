// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The mean that fits ratios and figures of different scale.
#pragma once

#include <cmath>
#include <optional>

namespace deltamesh::bench {

/// Collects numbers above 0; anything else makes the mean void.
class GeometricMean {
 public:
  void add(double value) {
    ++count_;
    log_sum_ += std::log(value);
  }
  /// Nothing without numbers, or where one of them was not above 0.
  std::optional<double> value() const {
    const double mean = std::exp(log_sum_ / count_);
    if (count_ == 0 || !std::isfinite(mean) || mean <= 0) return std::nullopt;
    return mean;
  }

 private:
  int count_ = 0;
  double log_sum_ = 0;
};

}  // namespace deltamesh::bench
