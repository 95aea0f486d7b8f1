// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// How a number of bytes is shared between positions and attributes: all errors grow and shrink together.
#pragma once

#include <cstdint>
#include <optional>

#include "base/portable_math.h"
#include "deltamesh/attribute_quality.h"

namespace deltamesh {

/// `quality` with every bound `scale` times as large, at most to where an attribute would mean nothing any
/// more. Exact colours stay exact up to a scale of 1; then they may be off by `scale` - 1 255ths. `scale`:
/// above 0.
AttributeQuality scaled(const AttributeQuality& quality, double scale);

/// Looks for the scale of errors whose stream comes nearest to a number of bytes from below.
class ScaleSearch {
 public:
  explicit ScaleSearch(std::uint64_t most_bytes) : most_bytes_(static_cast<double>(most_bytes)) {}

  /// Of the next trial.
  double scale() const noexcept { return portable_exp2(exponent_); }
  /// How many bytes that took. Returns whether they fit.
  bool tell(std::uint64_t bytes);
  /// Whether another trial would gain next to nothing.
  bool is_done() const noexcept { return done_; }
  /// Whether even the finest scale fits.
  bool has_room() const noexcept { return fits_ && fits_->exponent <= kFinest; }

 private:
  /// A tried scale, as an exponent of 2, and what it took; bytes fall about as the exponent grows.
  struct Trial {
    double exponent = 0;
    double bytes = 0;
  };
  static constexpr double kFinest = -12;
  static constexpr double kCoarsest = 12;

  double most_bytes_;
  double exponent_ = 0;
  bool done_ = false;
  std::optional<Trial> too_large_;
  std::optional<Trial> fits_;
};

}  // namespace deltamesh
