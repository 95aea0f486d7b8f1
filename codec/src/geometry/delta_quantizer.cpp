// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "geometry/delta_quantizer.h"

#include <algorithm>

namespace deltamesh {
namespace {

/// Mean distance of the deltas of one class from their symbols, towards zero.
class MeanShift {
 public:
  void add(double shift) noexcept {
    sum_ += shift;
    ++count_;
  }
  std::int8_t rounded() const noexcept {
    if (count_ == 0) return 0;
    const double units = std::round(256 * sum_ / static_cast<double>(count_));
    return static_cast<std::int8_t>(std::clamp(units, -127.0, 127.0));
  }

 private:
  double sum_ = 0;
  std::uint64_t count_ = 0;
};

}  // namespace

ReconstructionShift centroid_shift(const DeltaQuantizer& quantizer, std::span<const Vec3> deltas) noexcept {
  MeanShift one;
  MeanShift more;
  for (const Vec3& delta : deltas) {
    for (const double x : delta) {
      const double steps = std::abs(x) / quantizer.step;
      const double symbol = std::abs(quantizer.symbol(x));
      if (symbol == 1) one.add(symbol - steps);
      if (symbol > 1) more.add(symbol - steps);
    }
  }
  return {.one = one.rounded(), .more = more.rounded()};
}

}  // namespace deltamesh
