// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What the coded neighbourhood says of the next quantised delta: a mean, a scale and contexts. Integers only;
// shared by writer and reader [FLD-2 .. FLD-7].
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "topology/adjacency.h"

namespace deltamesh {

/// Sums over the coded neighbours of a vertex, divided by their number; in 1/16 steps and 1/16 squared steps
/// [FLD-3].
struct FieldNeighborhood {
  std::array<std::int32_t, 3> mean{};       ///< signed
  std::array<std::int32_t, 3> magnitude{};  ///< smoothed absolute values
  std::array<std::int32_t, 6> moments{};    ///< xx, xy, xz, yy, yz, zz, smoothed
  std::uint32_t degree_class = 0;           ///< of the vertex itself, in the whole graph: 0 to 7
  bool empty = true;
};

/// What is remembered of every coded vertex [FLD-2].
class FieldHistory {
 public:
  explicit FieldHistory(const Adjacency& graph) : graph_(graph), records_(graph.vertex_count()) {}

  FieldNeighborhood around(std::uint32_t vertex) const noexcept;

  /// `q`: the vertex's deltas; `before`: what around() said of it.
  void remember(std::uint32_t vertex, const std::array<std::int32_t, 3>& q,
                const FieldNeighborhood& before) noexcept;

 private:
  struct Record {
    std::array<std::int32_t, 3> q{};  ///< clamped
    std::array<std::int32_t, 3> magnitude{};
    std::array<std::int32_t, 6> moments{};
  };

  const Adjacency& graph_;
  std::vector<Record> records_;
};

/// The forecast for one axis of one vertex.
struct FieldForecast {
  std::int32_t mean = 0;    ///< 1/16 steps
  std::int32_t scale = 1;   ///< expected distance from it, 1/16 steps, 1 or more
  unsigned shift = 0;       ///< low bits outside the symbol [FLD-5]
  bool negative = false;    ///< the mean is below 0: signs are swapped
  std::int32_t center = 0;  ///< symbol units taken off
  std::array<std::uint32_t, 4> contexts{};
  std::uint32_t weight_set = 0;
  std::uint32_t tail_context = 0;
};

inline constexpr std::array<std::uint32_t, 4> kFieldContexts = {24 * 6 * 5, 24 * 8 * 3 * 3, 24 * 12 * 2,
                                                                12 * 8 * 3};
inline constexpr std::uint32_t kFieldWeightSets = 18;
inline constexpr std::uint32_t kTailContexts = 4 * 6;

/// Forecasts the three axes of a vertex in turn: forecast(0), learn(0), forecast(1) and so on.
class FieldPredictor {
 public:
  void begin(const FieldNeighborhood& around) noexcept { around_ = around; }
  FieldForecast forecast(unsigned axis) noexcept;
  void learn(unsigned axis, std::int32_t q, const FieldForecast& forecast) noexcept;

 private:
  /// Expected q of `axis` given the axes before it, by the neighbours' second moments; 1/16 steps [FLD-4].
  std::int32_t regress(unsigned axis) noexcept;
  std::int32_t expected_scale(unsigned axis) const noexcept;

  FieldNeighborhood around_;
  std::array<std::int32_t, 3> q_{};         ///< clamped, axes coded so far
  std::array<std::int32_t, 2> features_{};  ///< of the current axis: regression, neighbours' mean
  std::int32_t y_residual_ = 0;
  std::int32_t y_on_x_ = 0;
  std::int32_t z_on_x_ = 0;
  std::array<std::array<std::int32_t, 2>, 3> weights_{{{0, 0}, {65536, 0}, {65536, 0}}};
};

}  // namespace deltamesh
