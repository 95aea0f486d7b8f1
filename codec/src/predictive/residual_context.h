// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What coded neighbours, and the spread of the sources of a prediction, say of how far off it is
// [POSN-5, POSN-6]. Integers only; shared by writer and reader.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "predictive/blend.h"

namespace deltamesh {

inline constexpr std::array<std::uint32_t, 4> kResidualContexts = {24 * 5 * 5, 24 * 5 * 3, 24 * 3 * 5,
                                                                   24 * 3 * 3};
inline constexpr std::uint32_t kResidualWeightSets = 15;
inline constexpr std::uint32_t kResidualTails = 5;

/// Forecast of one axis.
struct ResidualForecast {
  std::int64_t whole = 0;  ///< the expected coordinate
  unsigned shift = 0;      ///< low bits outside the symbol
  int scale_bits = 0;      ///< of the expected distance, 1/16 steps
  bool negative = false;   ///< signs are swapped
  std::array<std::uint32_t, 4> contexts{};
  std::uint32_t weight_set = 0;
  std::uint32_t tail_context = 0;
};

/// Distances between vertices and what was expected of them, vertex after vertex: begin(), then forecast()
/// and learn() for each axis, or settle(), then end().
class ResidualHistory {
 public:
  explicit ResidualHistory(std::uint32_t vertex_count) : records_(vertex_count) {}

  void begin(const Surroundings& around, const Expectation& expected) noexcept;
  /// `least` and `most`: what a coordinate may be.
  ResidualForecast forecast(std::size_t axis, std::int32_t least, std::int32_t most) const noexcept;
  void learn(std::size_t axis, std::int32_t coordinate, const ResidualForecast& forecast) noexcept;
  /// In place of forecast() and learn(): the vertex was coded otherwise.
  void settle(const Cell& cell) noexcept;
  void end(std::uint32_t vertex) noexcept;

 private:
  struct Record {
    std::array<std::int32_t, 3> residual{};   ///< 1/16 steps, clamped
    std::array<std::int32_t, 3> magnitude{};  ///< smoothed
  };

  void remember(std::size_t axis, std::int32_t coordinate) noexcept;

  std::vector<Record> records_;
  Expectation expected_;
  std::uint32_t sources_ = 0;                 ///< 0 none, 1 neighbours, 2 .. 4 one to three parallelograms
  bool alone_ = true;                         ///< no coded neighbours
  std::array<std::int64_t, 3> residuals_{};   ///< means of the neighbours'
  std::array<std::int64_t, 3> magnitudes_{};  ///< likewise
  std::array<std::int64_t, 3> coded_{};       ///< |residual| of this vertex, 1/16 steps
  Record now_;
};

}  // namespace deltamesh
