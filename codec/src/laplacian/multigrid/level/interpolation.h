// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A node's row of P: its value from those of up to three nodes of the next coarser level.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace deltamesh::multigrid {

/// Weights are sixteenths with a sum of 1. Finer weights do not converge faster, and sweeps are limited by
/// memory.
class Interpolation {
 public:
  /// Largest number of nodes of a coarser level.
  static constexpr std::uint32_t kMostNodes = std::uint32_t{1} << 28;

  Interpolation() = default;

  /// The value of one node.
  explicit Interpolation(std::uint32_t node) noexcept : Interpolation({node, node, node}, 0, 0) {}

  /// `second`, `third`: weights of the last two in sixteenths, together below 15; where one is 0 its node is
  /// the first.
  Interpolation(const std::array<std::uint32_t, 3>& nodes, std::uint32_t second, std::uint32_t third) noexcept
      : terms_{nodes[0] | (second + third) << kNodeBits, nodes[1] | second << kNodeBits,
               nodes[2] | third << kNodeBits} {}

  std::uint32_t node(std::size_t k) const noexcept { return terms_[k] % kMostNodes; }
  float weight(std::size_t k) const noexcept {
    return (k == 0 ? kLeftOfOne : kSixteenths)[terms_[k] >> kNodeBits];
  }

  /// Whether that weight is above 0.
  bool counts(std::size_t k) const noexcept { return k == 0 || terms_[k] >= kMostNodes; }

  /// `coarse`: of one field or both.
  template <class Values>
  auto of(const Values& coarse) const noexcept {
    return weight(0) * coarse[node(0)] + weight(1) * coarse[node(1)] + weight(2) * coarse[node(2)];
  }

  /// Adds the node's column of P^T times `fine` to each(coarse node).
  template <class Value, class Each>
  void spread(const Value& fine, const Each& each) const {
    for (std::size_t k = 0; k < 3; ++k) each(node(k)) += weight(k) * fine;
  }

 private:
  static constexpr unsigned kNodeBits = 28;
  using Weights = std::array<float, 16>;  ///< of every code
  static constexpr Weights kSixteenths = [] {
    Weights values{};
    for (std::size_t code = 0; code < values.size(); ++code) values[code] = static_cast<float>(code) / 16;
    return values;
  }();
  static constexpr Weights kLeftOfOne = [] {
    Weights values{};
    for (std::size_t code = 0; code < values.size(); ++code) values[code] = 1 - kSixteenths[code];
    return values;
  }();

  std::array<std::uint32_t, 3>
      terms_;  ///< a node, and above it its weight; of the first what that lacks of 1
};

}  // namespace deltamesh::multigrid
