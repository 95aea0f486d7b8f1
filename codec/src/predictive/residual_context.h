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
#include <memory>

#include "base/floor_log2.h"
#include "base/four_ints.h"
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
constexpr std::uint32_t quarter_octave(std::int64_t value) noexcept {
  return kQuarterOctave[static_cast<std::size_t>(std::min<std::int64_t>(value, 127))];
}

/// Distances between vertices and what was expected of them, vertex after vertex: begin(), then forecast()
/// and learn() for each axis, or settle(), then end().
class ResidualHistory {
 public:
  explicit ResidualHistory(std::uint32_t vertex_count)
      : records_(std::make_unique_for_overwrite<Record[]>(vertex_count)) {}

  [[gnu::always_inline]] void begin(const Surroundings& around, const Expectation& expected) noexcept {
    expected_ = expected;
    const unsigned count = around.neighbor_count;
    sources_ =
        around.parallelogram_count > 0 ? std::min(around.parallelogram_count, 3U) + 1 : std::min(count, 1U);
    means_ = Record{};
    for (unsigned i = 0; i < count; ++i) {
      const Record& record = records_[around.neighbors[i]];
      means_.residual += record.residual;
      means_.magnitude += record.magnitude;
    }
    means_.residual = mean_lanes(means_.residual, count);
    means_.magnitude = mean_lanes(means_.magnitude, count);
    all_ = static_cast<std::int64_t>((std::uint64_t{static_cast<std::uint32_t>(means_.magnitude[0])} +
                                      static_cast<std::uint32_t>(means_.magnitude[1]) +
                                      static_cast<std::uint32_t>(means_.magnitude[2])) /
                                     3);
  }

  /// `least` and `most`: what a coordinate may be.
  template <std::size_t kAxis>
  [[gnu::always_inline]] ResidualForecast forecast(std::int64_t least, std::int64_t most) const noexcept {
    constexpr auto kA = static_cast<std::uint32_t>(kAxis);
    const std::int64_t own = means_.magnitude[kAxis];
    const std::int64_t spread = expected_.spread[kAxis];
    const std::int64_t coded = kAxis == 0 ? 0 : kAxis == 1 ? coded_[0] : (coded_[0] + coded_[1]) >> 1;
    std::int64_t scale = kAxis == 0 ? (39 * own + 22 * all_) >> 6 : (32 * own + 20 * all_ + 6 * coded) >> 6;
    const std::int64_t blended = (scale + spread) >> 1;
    scale = sources_ > 2 ? blended : sources_ < 2 ? std::max(scale, spread) : scale;
    ++scale;

    ResidualForecast f;
    const std::int64_t place = expected_.place[kAxis];
    const std::int64_t rounded = (place + 8) >> 4;
    f.whole = std::clamp(rounded, least, most);
    const std::int64_t mean = place - 16 * rounded - (means_.residual[kAxis] >> 2);
    f.sign = mean >> 63;
    f.scale_bits = static_cast<int>(floor_log2(static_cast<std::uint64_t>(scale))) + 1;
    f.shift = static_cast<unsigned>(std::max(f.scale_bits - 6, 0));
    const std::uint32_t shifted = f.shift > 0 ? 1 : 0;
    const auto distance = static_cast<std::uint32_t>(std::min<std::int64_t>((mean ^ f.sign) - f.sign, 8)) / 2;
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
    coded_[kAxis] = 16 * std::abs(coordinate - forecast.whole);
    remember<kAxis>(coordinate);
  }

  /// In place of forecast() and learn(): the vertex was coded otherwise.
  [[gnu::always_inline]] void settle(const Cell& cell) noexcept {
    remember<0>(cell[0]);
    remember<1>(cell[1]);
    remember<2>(cell[2]);
  }

  [[gnu::always_inline]] void end(std::uint32_t vertex) noexcept {
    const FourInts residual = {now_[0], now_[1], now_[2], 0};
    const FourInts size = lane_sizes(residual);
    records_[vertex] = Record{residual, sources_ == 0 ? size : smooth_lanes(size, means_.magnitude)};
  }

 private:
  struct Record {
    FourInts residual;   ///< x, y, z in 1/16 steps, clamped; 0
    FourInts magnitude;  ///< smoothed
  };
  static constexpr std::int64_t kLargestRemembered = 1 << 26;  ///< 1/16 steps

  template <std::size_t kAxis>
  [[gnu::always_inline]] void remember(std::int32_t coordinate) noexcept {
    now_[kAxis] = static_cast<std::int32_t>(std::clamp(16 * std::int64_t{coordinate} - expected_.place[kAxis],
                                                       -kLargestRemembered, kLargestRemembered));
  }

  std::unique_ptr<Record[]> records_;
  Expectation expected_;
  std::uint32_t sources_ = 0;            ///< 0 none, 1 neighbours, 2 .. 4 one to three parallelograms
  Record means_;                         ///< over the neighbours
  std::int64_t all_ = 0;                 ///< mean of the magnitudes of all axes
  std::array<std::int64_t, 3> coded_{};  ///< |residual| of this vertex, 1/16 steps
  std::array<std::int32_t, 3> now_{};
};

}  // namespace deltamesh
