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

/// Four classes per octave from 4 on, 23 at most, which are those from 112 on.
inline constexpr std::array<std::uint8_t, 128> kQuarterOctave = [] {
  std::array<std::uint8_t, 128> classes{};
  for (unsigned v = 0; v < classes.size(); ++v) {
    const auto width = static_cast<unsigned>(std::bit_width(v));
    classes[v] =
        static_cast<std::uint8_t>(v < 4 ? v : std::min(4 * (width - 2) + ((v >> (width - 3)) & 3), 23U));
  }
  return classes;
}();
constexpr std::uint32_t quarter_octave(std::uint32_t value) noexcept {
  return kQuarterOctave[std::min(value, 127U)];
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
    distance_ = numbers_of((mean ^ sign) - sign);
    const std::array<std::int32_t, 4> own = numbers_of(magnitude_);
    const FourInts all = FourInts{} + (own[0] + own[1] + own[2]) / 3;  // below 2^28
    FourInts scale = smooth_lanes(magnitude_, all);
    // Chosen without branches, as sources change often.
    const FourInts has_parallelograms = FourInts{} - (sources_ >= 3 ? 1 : 0);
    const FourInts has_few = FourInts{} - (sources_ < 2 ? 1 : 0);
    const FourInts larger = scale + ((expected.spread - scale) & ((expected.spread > scale) & has_few));
    scale = larger + ((((scale + expected.spread) >> 1) - scale) & has_parallelograms) + 1;
    scale_ = numbers_of(scale);
    spread_ = numbers_of(expected.spread);
  }

  /// `least` and `most`: what a coordinate may be.
  [[gnu::always_inline]] ResidualForecast forecast(std::size_t axis, std::int64_t least,
                                                   std::int64_t most) const noexcept {
    const auto a = static_cast<std::uint32_t>(axis);
    const auto scale = static_cast<std::uint32_t>(scale_[axis]);
    const auto spread = static_cast<std::uint32_t>(spread_[axis]);
    ResidualForecast f;
    f.whole = std::clamp<std::int64_t>(nearest_[axis], least, most);
    f.sign = sign_[axis];
    f.scale_bits = static_cast<int>(floor_log2(scale)) + 1;
    f.shift = static_cast<unsigned>(std::max(f.scale_bits - 6, 0));
    const std::uint32_t shifted = f.shift > 0 ? 1 : 0;
    const auto distance = static_cast<std::uint32_t>(std::min(distance_[axis], 8)) / 2;
    // Where the place between two coordinates says nothing, how the axes before turned out does.
    const std::uint32_t turned_out =
        axis == 0 ? 0U : (4 * coded_ < scale ? 1U : 0U) + (coded_ >= 2 * scale ? 2U : 0U);
    const std::uint32_t sure = shifted != 0 ? turned_out : distance;
    const std::uint32_t scale_class = quarter_octave(scale >> f.shift) + 4 * shifted;
    f.contexts = {(scale_class * 5 + sources_) * 5 + sure,
                  (quarter_octave(spread >> f.shift) * 5 + sources_) * 3 + a};
    f.weight_set = a * 5 + sources_;
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
    // Beyond 2^23 steps it is the clamped one anyway, as offsets are below 2^26.
    const FourInts steps = clamp_lanes(cell - whole_, 1 << 23);
    const FourInts residual = clamp_lanes((steps << 4) - offset_, kLargestResidual);
    const FourInts size = lane_sizes(residual);
    return {residual, sources_ == 0 ? size : smooth_lanes(size, magnitude_)};
  }

 private:
  FourInts whole_;                        ///< as in Expectation
  FourInts offset_;                       ///< likewise
  FourInts magnitude_;                    ///< mean of corners of known faces
  std::array<std::int32_t, 4> nearest_;   ///< the expected lattice point
  std::array<std::int32_t, 4> sign_;      ///< -1 where the vertex is likely below, else 0
  std::array<std::int32_t, 4> distance_;  ///< how far it is likely from there, 1/16 steps
  std::array<std::int32_t, 4> scale_;     ///< what distance may be expected, 1/16 steps
  std::array<std::int32_t, 4> spread_;
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
