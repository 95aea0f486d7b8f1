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

#include "base/floor_log2.h"
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

/// Distances between vertices and what was expected of them, vertex after vertex: begin(), forecast() and
/// learn() for each axis where these are of use, end().
class ResidualHistory {
 public:
  explicit ResidualHistory(std::uint32_t vertex_count) : records_(vertex_count) {}

  [[gnu::always_inline]] void begin(const Surroundings& around, const Expectation& expected) noexcept {
    sources_ = around.parallelogram_count > 0 ? std::min(around.parallelogram_count, 3U) + 1
                                              : std::min(around.known_count, 1U);
    means_ = Record{};
    for (unsigned i = 0; i < around.known_count; ++i) {
      const Record& a = records_[around.known[i].a];
      const Record& b = records_[around.known[i].b];
      means_.residual += a.residual + b.residual;
      means_.magnitude += a.magnitude + b.magnitude;
    }
    means_.residual = mean_lanes(means_.residual, 2 * around.known_count);
    means_.magnitude = mean_lanes(means_.magnitude, 2 * around.known_count);
    all_ =
        (static_cast<std::uint32_t>(means_.magnitude[0]) + static_cast<std::uint32_t>(means_.magnitude[1]) +
         static_cast<std::uint32_t>(means_.magnitude[2])) /
        3;
    whole_ = expected.whole;
    offset_ = expected.offset;
    spread_ = expected.spread;
    rounded_ = (offset_ + 8) >> 4;
    mean_ = offset_ - (rounded_ << 4) - (means_.residual >> 2);
    rounded_ += whole_;
  }

  /// `least` and `most`: what a coordinate may be.
  template <std::size_t kAxis>
  [[gnu::always_inline]] ResidualForecast forecast(std::int64_t least, std::int64_t most) const noexcept {
    constexpr auto kA = static_cast<std::uint32_t>(kAxis);
    const auto own = static_cast<std::uint32_t>(means_.magnitude[kAxis]);
    const auto spread = static_cast<std::uint32_t>(spread_[kAxis]);
    const std::uint32_t coded = kAxis == 0 ? 0 : kAxis == 1 ? coded_[0] : (coded_[0] + coded_[1]) >> 1;
    // Below 2^32, as magnitudes are hardly above 2^26.
    std::uint32_t scale = kAxis == 0 ? (39 * own + 22 * all_) >> 6 : (32 * own + 20 * all_ + 6 * coded) >> 6;
    const std::uint32_t blended = (scale + spread) >> 1;
    scale = sources_ > 2 ? blended : sources_ < 2 ? std::max(scale, spread) : scale;
    ++scale;

    ResidualForecast f;
    f.whole = std::clamp<std::int64_t>(rounded_[kAxis], least, most);
    const std::int32_t mean = mean_[kAxis];
    f.sign = mean >> 31;
    f.scale_bits = static_cast<int>(floor_log2(scale)) + 1;
    f.shift = static_cast<unsigned>(std::max(f.scale_bits - 6, 0));
    const std::uint32_t shifted = f.shift > 0 ? 1 : 0;
    const auto distance = static_cast<std::uint32_t>(std::min((mean ^ (mean >> 31)) - (mean >> 31), 8)) / 2;
    // Where the place between two coordinates says nothing, how the axes before turned out does.
    const std::uint32_t turned_out =
        kAxis == 0 ? 0U : (4 * coded < scale ? 1U : 0U) + (coded >= 2 * scale ? 2U : 0U);
    const std::uint32_t sure = shifted != 0 ? turned_out : distance;
    const std::uint32_t scale_class = quarter_octave(scale >> f.shift) + 4 * shifted;
    f.contexts = {(scale_class * 5 + sources_) * 5 + sure,
                  (quarter_octave(spread >> f.shift) * 5 + sources_) * 3 + kA};
    f.weight_set = kA * 5 + sources_;
    f.tail_context = sources_;
    return f;
  }

  template <std::size_t kAxis>
  [[gnu::always_inline]] void learn(std::int32_t coordinate, const ResidualForecast& forecast) noexcept {
    coded_[kAxis] = static_cast<std::uint32_t>(
        std::min(16 * std::abs(coordinate - forecast.whole), std::int64_t{kLargestRemembered}));
  }

  /// After learn() of all axes, or where the vertex was coded otherwise.
  [[gnu::always_inline]] void end(std::uint32_t vertex, const Cell& cell) noexcept {
    // Beyond 2^23 steps it is the clamped one anyway, as offsets are below 2^26.
    const FourInts steps = clamp_lanes(four_ints(cell) - whole_, 1 << 23);
    const FourInts residual = clamp_lanes((steps << 4) - offset_, kLargestRemembered);
    const FourInts size = lane_sizes(residual);
    records_[vertex] = Record{residual, sources_ == 0 ? size : smooth_lanes(size, means_.magnitude)};
  }

 private:
  struct Record {
    FourInts residual;   ///< x, y, z in 1/16 steps, clamped; 0
    FourInts magnitude;  ///< smoothed
  };
  static constexpr std::int32_t kLargestRemembered = 1 << 26;  ///< 1/16 steps

  LargeVector<Record> records_;
  std::uint32_t sources_ = 0;  ///< 0 none, 1 neighbours, 2 .. 4 one to three parallelograms
  Record means_;               ///< over the corners of known faces
  std::uint32_t all_ = 0;      ///< mean of the magnitudes of all axes
  FourInts whole_{};           ///< as in Expectation, and the two that follow
  FourInts offset_{};
  FourInts spread_{};
  FourInts rounded_{};                    ///< the expected lattice point
  FourInts mean_{};                       ///< from there to where the vertex is most likely, 1/16 steps
  std::array<std::uint32_t, 3> coded_{};  ///< |residual| of this vertex, 1/16 steps
};

}  // namespace deltamesh
