// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Which coded vertices tell the colour of the next one, and with what weights [ATTR-47]. Shared by
// writer and reader; f32 arithmetic in the order written.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <vector>

#include "attributes/surface.h"
#include "base/memory/large_vector.h"
#include "base/simd/four_floats.h"
#include "base/simd/four_ints.h"

namespace deltamesh {

/// The coded vertices that predict a colour, and their weights.
struct ColorPlace {
  /// Coded vertices: the last copy of the vertex before, then neighbours. None for the first of a component.
  std::span<const std::uint32_t> vertices;
  /// Their weights: above 0, with a sum of 1.
  std::span<const float> shares;
};

/// Weighs the vertices in coding order.
class ColorPrediction {
 public:
  static constexpr std::uint32_t kRow = 4;     ///< neighbours of a vertex that are looked at
  static constexpr float kNearest = 1.0F / 4;  ///< added to squared distances, which are 1 in the mean

  /// `surface` must outlive this.
  explicit ColorPrediction(const AttributeSurface& surface)
      : graph_(surface.graph()), surface_(surface), latest_(surface.geometric().size(), kNone) {
    const std::span<const float> p = surface.positions();
    places_.resize(p.size() / 3);
    for (std::size_t v = 0; v < places_.size(); ++v)
      places_[v] = FourFloats{p[3 * v], p[3 * v + 1], p[3 * v + 2], 0};
  }

  /// For every vertex once, in order. Valid until the next call. O(1).
  [[gnu::always_inline]] ColorPlace look(std::uint32_t vertex) noexcept {
    find_near(vertex);
    if (places_.empty() || count_ == 0 || !weigh_by_distance(vertex)) {
      for (std::size_t i = 0; i < count_; ++i) shares_[i] = 1 / static_cast<float>(count_);
    }
    return {{vertices_.data(), count_}, {shares_.data(), count_}};
  }

 private:
  static constexpr std::size_t kMostNear = kRow + 1;
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

  void find_near(std::uint32_t vertex) noexcept {
    count_ = 0;
    if (!latest_.empty()) {
      std::uint32_t& latest = latest_[surface_.geometric_of(vertex)];
      if (latest != kNone) vertices_[count_++] = latest;
      latest = vertex;
    }
    add_coded(vertex);
  }

  /// Adds those of the `kRow` lowest neighbours that are below `vertex`, without a branch for each.
  [[gnu::always_inline]] void add_coded(std::uint32_t vertex) noexcept {
    const std::uint32_t begin = graph_.offsets[vertex];
    const std::uint32_t degree = std::min(graph_.offsets[vertex + 1] - begin, kRow);
    std::array<std::uint32_t, kRow> row{};
    if (begin + std::size_t{kRow} <= graph_.neighbors.size()) [[likely]] {
      std::memcpy(row.data(), graph_.neighbors.data() + begin, sizeof row);
    } else {
      std::copy_n(graph_.neighbors.data() + begin, degree, row.data());
    }
    std::memcpy(vertices_.data() + count_, row.data(), sizeof row);
    FourInts four;
    std::memcpy(&four, row.data(), sizeof four);
    const FourInts limit = FourInts{} + static_cast<std::int32_t>(vertex);
    const unsigned below = set_lanes(four < limit);
    // Rows ascend: the set bits are the lowest.
    count_ += static_cast<std::size_t>(std::countr_one(below & ((1U << degree) - 1)));
  }

  static float square(FourFloats p) noexcept {
    const FourFloats squares = p * p;
    return (squares[0] + squares[1]) + squares[2];
  }

  /// False where distances are of no use.
  [[gnu::always_inline]] bool weigh_by_distance(std::uint32_t vertex) noexcept {
    const FourFloats here = places_[vertex];
    float sum = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      shares_[i] = square(places_[vertices_[i]] - here);
      sum += shares_[i];
    }
    const float mean = sum / static_cast<float>(count_);
    if (!(mean >= std::numeric_limits<float>::min() && mean <= std::numeric_limits<float>::max()))
      return false;
    const float one_over = 1 / mean;
    float all = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      const float closeness = 1 / (shares_[i] * one_over + kNearest);
      shares_[i] = closeness * closeness;
      all += shares_[i];
    }
    const float one_over_all = 1 / all;
    for (std::size_t i = 0; i < count_; ++i) shares_[i] *= one_over_all;
    return true;
  }

  const Adjacency& graph_;
  const AttributeSurface& surface_;
  LargeVector<FourFloats> places_;     ///< positions; empty where they are not known
  std::vector<std::uint32_t> latest_;  ///< by geometric vertex: its last coded copy
  std::size_t count_ = 0;
  std::array<std::uint32_t, kMostNear> vertices_{};
  std::array<float, kMostNear> shares_{};
};

}  // namespace deltamesh
