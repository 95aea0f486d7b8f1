// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What coded neighbours, and the spread of the sources of a prediction, say of how far off it is
// [POSN-5, POSN-6]. Integers only; shared by writer and reader.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "base/four_ints.h"
#include "base/large_vector.h"
#include "predictive/blend.h"

namespace deltamesh {

inline constexpr std::size_t kResidualModels = 2;
inline constexpr std::array<std::uint32_t, kResidualModels> kResidualContexts = {24 * 5 * 5, 24 * 5 * 3};
inline constexpr std::uint32_t kResidualWeightSets = 15;
inline constexpr std::uint32_t kResidualTails = 5;

/// Forecast of one axis.
struct ResidualForecast {
  std::int64_t whole = 0;  ///< the expected coordinate
  unsigned shift = 0;      ///< low bits outside the symbol
  int scale_bits = 0;      ///< of the expected distance, 1/16 steps
  std::int64_t sign = 0;   ///< -1 where signs are swapped, else 0
  std::array<std::uint32_t, kResidualModels> contexts{};
  std::uint32_t weight_set = 0;
  std::uint32_t tail_context = 0;
};

/// 4 floor(log2 x) and the two bits of x below its leading one, of every lane x, 1 to 2^24 - 1; far below 0
/// for 0.
inline FourInts quarter_octaves(FourInts lanes) noexcept {
  using FourFloats = float __attribute__((vector_size(16)));
  // Such numbers are floats exactly, and these have it all in place.
  const auto floats = __builtin_convertvector(lanes, FourFloats);
  return (std::bit_cast<FourInts>(floats) >> 21) - 4 * 127;
}

/// What is kept of a coded vertex [POSN-5].
struct ResidualRecord {
  FourInts residual;   ///< x, y, z in 1/16 steps, clamped; 0
  FourInts magnitude;  ///< smoothed
};

inline constexpr std::int32_t kLargestResidual = 1 << 26;  ///< 1/16 steps

/// A vertex while it is coded: forecast() and learn() of the axes in order, where these are of use, record().
class ResidualTurn {
 public:
  [[gnu::always_inline]] ResidualTurn(const Surroundings& around, const Expectation& expected,
                                      const ResidualRecord& means) noexcept
      : whole_(expected.whole),
        offset_(expected.offset),
        magnitude_(means.magnitude),
        sources_(around.parallelogram_count > 0 ? std::min(around.parallelogram_count, 3U) + 1
                                                : std::min(around.known_count, 1U)) {
    const FourInts rounded = (offset_ + 8) >> 4;
    const FourInts mean = offset_ - (rounded << 4) - (means.residual >> 2);
    const FourInts sign = mean >> 31;
    nearest_ = numbers_of(whole_ + rounded);
    sign_ = numbers_of(sign);
    const FourInts distance = least_lanes((mean ^ sign) - sign, 8) >> 1;

    const std::array<std::int32_t, 4> own = numbers_of(magnitude_);
    const FourInts all = FourInts{} + (own[0] + own[1] + own[2]) / 3;  // below 2^28
    FourInts scale = smooth_lanes(magnitude_, all);
    // Chosen without branches, as sources change often.
    const auto sources = static_cast<std::int32_t>(sources_);
    const FourInts has_parallelograms = FourInts{} - (sources >= 3 ? 1 : 0);
    const FourInts has_few = FourInts{} - (sources < 2 ? 1 : 0);
    const FourInts larger = (expected.spread - scale) & ((expected.spread > scale) & has_few);
    const FourInts between = (((scale + expected.spread) >> 1) - scale) & has_parallelograms;
    scale = least_lanes(scale + larger + between + 1, kLargestScale);
    scale_ = numbers_of(scale);

    const FourInts octaves = quarter_octaves(scale);
    const FourInts bits = (octaves >> 2) + 1;
    const FourInts shift = (bits - kSymbolBits) & (bits > kSymbolBits);
    scale_bits_ = numbers_of(bits);
    shift_ = numbers_of(shift);
    const FourInts is_shifted = shift > 0;
    const FourInts few = octaves >> 1;
    const FourInts more = octaves - 4;
    const FourInts whole_class = few + ((more - few) & (more > few));
    const FourInts scale_class = whole_class + (((octaves - (shift << 2)) - whole_class) & is_shifted);
    contexts_[0] = numbers_of(five_times(five_times(scale_class) + sources) + (distance & ~is_shifted));

    const FourInts apart = quarter_octaves(least_lanes(expected.spread, kLargestScale)) - (shift << 2);
    const FourInts near = (apart + 2) >> 1;
    const FourInts far = apart - 3;
    const FourInts any_class = least_lanes(near + ((far - near) & (far > near)), kSpreadClasses - 1);
    const FourInts spread_class = any_class & ~(any_class >> 31);
    const FourInts spread_sources = five_times(spread_class) + sources;
    contexts_[1] = numbers_of((spread_sources << 1) + spread_sources + FourInts{0, 1, 2, 0});
  }

  /// `least` and `most`: what a coordinate may be.
  [[gnu::always_inline]] ResidualForecast forecast(std::size_t axis, std::int64_t least,
                                                   std::int64_t most) const noexcept {
    ResidualForecast f;
    f.whole = std::clamp<std::int64_t>(nearest_[axis], least, most);
    f.sign = sign_[axis];
    f.scale_bits = scale_bits_[axis];
    f.shift = static_cast<unsigned>(shift_[axis]);
    f.contexts = {static_cast<std::uint32_t>(contexts_[0][axis]),
                  static_cast<std::uint32_t>(contexts_[1][axis])};
    // Where the place between two coordinates says nothing, how the axes before turned out does.
    if (f.shift > 0 && axis > 0) {
      const auto scale = static_cast<std::uint32_t>(scale_[axis]);
      f.contexts[0] += (4 * coded_ < scale ? 1U : 0U) + (coded_ >= 2 * scale ? 2U : 0U);
    }
    f.weight_set = static_cast<std::uint32_t>(axis) * 5 + sources_;
    f.tail_context = sources_;
    return f;
  }

  [[gnu::always_inline]] void learn(std::size_t axis, std::int32_t coordinate,
                                    const ResidualForecast& forecast) noexcept {
    const auto off = static_cast<std::uint32_t>(
        std::min(16 * std::abs(coordinate - forecast.whole), std::int64_t{kLargestResidual}));
    coded_ = axis == 0 ? off : (coded_ + off) >> 1;
  }

  /// After learn() of all axes, or where the vertex was coded otherwise.
  [[gnu::always_inline]] ResidualRecord record(FourInts cell) const noexcept {
    const FourInts steps = cell - whole_;
    FourInts residual = (steps << 4) - offset_;
    // With few steps nothing is out of range, as offsets are below 2^26; many are clamped.
    constexpr std::int32_t kFew = 1 << 18;
    if (set_lanes(((steps + kFew) & ~(2 * kFew - 1)) != 0) != 0) [[unlikely]]
      residual = clamp_lanes((clamp_lanes(steps, 1 << 23) << 4) - offset_, kLargestResidual);
    const FourInts size = lane_sizes(residual);
    return {residual, sources_ == 0 ? size : smooth_lanes(size, magnitude_)};
  }

 private:
  static constexpr std::int32_t kLargestScale = (1 << 24) - 1;
  static constexpr std::int32_t kSymbolBits = 6;  ///< of a distance in 1/16 steps that a symbol tells
  static constexpr std::int32_t kSpreadClasses = 24;

  static FourInts five_times(FourInts lanes) noexcept { return (lanes << 2) + lanes; }

  FourInts whole_;                       ///< as in Expectation
  FourInts offset_;                      ///< likewise
  FourInts magnitude_;                   ///< mean of corners of known faces
  std::array<std::int32_t, 4> nearest_;  ///< the expected lattice point
  std::array<std::int32_t, 4> sign_;     ///< -1 where the vertex is likely below, else 0
  std::array<std::int32_t, 4> scale_;    ///< what distance may be expected, 1/16 steps, to kLargestScale
  std::array<std::int32_t, 4> scale_bits_;
  std::array<std::int32_t, 4> shift_;
  std::array<std::array<std::int32_t, 4>, kResidualModels> contexts_;  ///< without how axes before turned out
  std::uint32_t sources_;    ///< 0 none, 1 neighbours, 2 .. 4 one to three parallelograms
  std::uint32_t coded_ = 0;  ///< |residual| of the axes so far, 1/16 steps
};

/// Distances between vertices and what was expected of them.
class ResidualHistory {
 public:
  explicit ResidualHistory(std::uint32_t vertex_count) : records_(vertex_count) {}

  [[gnu::always_inline]] ResidualTurn begin(const Surroundings& around,
                                            const Expectation& expected) const noexcept {
    ResidualRecord means{};
    if (around.known_count > 0) {
      means = sum(around.known[0]);
      if (around.known_count > 1) {
        const ResidualRecord second = sum(around.known[1]);
        means.residual = (means.residual + second.residual) >> 1;
        means.magnitude = (means.magnitude + second.magnitude) >> 1;
      }
      means.residual >>= 1;
      means.magnitude >>= 1;
    }
    return {around, expected, means};
  }

  [[gnu::always_inline]] void end(std::uint32_t vertex, const ResidualTurn& turn, FourInts cell) noexcept {
    records_[vertex] = turn.record(cell);
  }

 private:
  ResidualRecord sum(const KnownFace& face) const noexcept {
    const ResidualRecord& a = records_[face.a];
    const ResidualRecord& b = records_[face.b];
    return {a.residual + b.residual, a.magnitude + b.magnitude};
  }

  LargeVector<ResidualRecord> records_;
};

}  // namespace deltamesh
