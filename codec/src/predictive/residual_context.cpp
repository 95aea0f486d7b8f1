// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "predictive/residual_context.h"

#include <algorithm>
#include <bit>
#include <cstdlib>

#include "base/mean.h"

namespace deltamesh {
namespace {

constexpr std::int64_t kLargestRemembered = 1 << 26;  ///< 1/16 steps

/// Four classes per octave from 4 on, at most `largest`.
std::uint32_t quarter_octave(std::int64_t value, std::uint32_t largest) noexcept {
  const auto v = static_cast<std::uint64_t>(value);
  if (v < 4) return static_cast<std::uint32_t>(v);
  const auto width = static_cast<unsigned>(std::bit_width(v));
  return std::min(4 * (width - 2) + static_cast<std::uint32_t>((v >> (width - 3)) & 3), largest);
}

}  // namespace

void ResidualHistory::begin(const Surroundings& around, const Expectation& expected) noexcept {
  expected_ = expected;
  alone_ = around.neighbor_count == 0;
  sources_ = around.parallelogram_count > 0 ? std::min(around.parallelogram_count, 3U) + 1 : (alone_ ? 0 : 1);
  residuals_ = {};
  magnitudes_ = {};
  if (alone_) return;
  for (unsigned i = 0; i < around.neighbor_count; ++i) {
    const Record& r = records_[around.neighbors[i]];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      residuals_[axis] += r.residual[axis];
      magnitudes_[axis] += r.magnitude[axis];
    }
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    residuals_[axis] = mean_of(residuals_[axis], around.neighbor_count);
    magnitudes_[axis] = mean_of(magnitudes_[axis], around.neighbor_count);
  }
}

ResidualForecast ResidualHistory::forecast(std::size_t axis, std::int32_t least,
                                           std::int32_t most) const noexcept {
  const std::int64_t all = (magnitudes_[0] + magnitudes_[1] + magnitudes_[2]) / 3;
  const std::int64_t own = magnitudes_[axis];
  const std::int64_t spread = expected_.spread[axis];
  const std::int64_t coded = axis == 0 ? 0 : axis == 1 ? coded_[0] : (coded_[0] + coded_[1]) / 2;
  std::int64_t scale = axis == 0 ? (39 * own + 22 * all) >> 6 : (32 * own + 20 * all + 6 * coded) >> 6;
  if (sources_ > 2) scale = (scale + spread) >> 1;
  if (sources_ < 2) scale = std::max(scale, spread);
  ++scale;

  ResidualForecast f;
  const std::int64_t place = expected_.place[axis];
  f.whole = std::clamp<std::int64_t>((place + 8) >> 4, least, most);
  const std::int64_t mean = place - 16 * ((place + 8) >> 4) - (residuals_[axis] >> 2);
  f.negative = mean < 0;
  f.scale_bits = static_cast<int>(std::bit_width(static_cast<std::uint64_t>(scale)));
  f.shift = static_cast<unsigned>(std::max(f.scale_bits - 6, 0));
  const std::uint32_t sure =
      f.shift > 0 ? 0 : static_cast<std::uint32_t>(std::min<std::int64_t>(std::llabs(mean), 8)) / 2;
  const std::uint32_t scale_class = quarter_octave(scale >> f.shift, 19) + (f.shift > 0 ? 4 : 0);
  const auto a = static_cast<std::uint32_t>(axis);
  f.contexts = {(scale_class * 5 + sources_) * 5 + sure,
                (quarter_octave(spread >> f.shift, 23) * 5 + sources_) * 3 + a,
                (quarter_octave(coded >> f.shift, 23) * 3 + a) * 5 + sources_,
                (quarter_octave(own >> f.shift, 23) * 3 + (sure + 1) / 2) * 3 + a};
  f.weight_set = a * 5 + sources_;
  f.tail_context = sources_;
  return f;
}

void ResidualHistory::learn(std::size_t axis, std::int32_t coordinate,
                            const ResidualForecast& forecast) noexcept {
  coded_[axis] = 16 * std::llabs(coordinate - forecast.whole);
  remember(axis, coordinate);
}

void ResidualHistory::settle(const Cell& cell) noexcept {
  for (std::size_t axis = 0; axis < 3; ++axis) remember(axis, cell[axis]);
}

void ResidualHistory::remember(std::size_t axis, std::int32_t coordinate) noexcept {
  const std::int64_t residual = std::clamp(16 * std::int64_t{coordinate} - expected_.place[axis],
                                           -kLargestRemembered, kLargestRemembered);
  const std::int64_t size = std::llabs(residual);
  now_.residual[axis] = static_cast<std::int32_t>(residual);
  now_.magnitude[axis] = static_cast<std::int32_t>(alone_ ? size : (5 * size + 3 * magnitudes_[axis]) >> 3);
}

void ResidualHistory::end(std::uint32_t vertex) noexcept { records_[vertex] = now_; }

}  // namespace deltamesh
