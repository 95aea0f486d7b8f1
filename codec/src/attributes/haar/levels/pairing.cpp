// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "attributes/haar/levels/pairing.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "attributes/haar/log_class.h"

namespace deltamesh {
namespace {

constexpr std::uint32_t kNobody = HaarChildren::kNone;
constexpr int kChoiceRounds = 2;  ///< of mutual choices

class Pairing {
 public:
  explicit Pairing(const HaarLevel& level)
      : level_(level), mates_(level.nodes.size()), choices_(level.nodes.size()) {
    for (std::uint32_t i = 0; i < mates_.size(); ++i) mates_[i] = choices_[i] = i;
  }

  LargeVector<std::uint32_t> take() noexcept { return std::move(mates_); }

  /// Joins nodes each of which is the other's cheapest free neighbour.
  void join_mutual_choices() {
    for (std::uint32_t i = 0; i < mates_.size(); ++i)
      if (is_free(i)) choose(i);
    for (std::uint32_t i = 0; i < mates_.size(); ++i) {
      const std::uint32_t j = choices_[i];
      if (j != kNobody && j > i && choices_[j] == i && is_free(i) && is_free(j)) join(i, j);
    }
  }

  /// Joins each free node in order with its cheapest free neighbour.
  void join_in_order() {
    for (std::uint32_t i = 0; i < mates_.size(); ++i) {
      if (!is_free(i)) continue;
      choose(i);
      if (choices_[i] != kNobody) join(i, choices_[i]);
    }
  }

  /// Joins free nodes whose cheapest neighbour is the same, which leaves one of them at most: that all
  /// neighbours of one node wait for it would take as many levels as there are neighbours.
  void join_rivals() {
    LargeVector<std::uint32_t> waiting_for(mates_.size(), kNobody);
    for (std::uint32_t i = 0; i < mates_.size(); ++i) {
      if (!is_free(i)) continue;
      const std::uint32_t j = cheapest(i, [](std::uint32_t) { return true; });
      if (j == kNobody) continue;
      std::uint32_t& waiting = waiting_for[j];
      if (waiting == kNobody) {
        waiting = i;
      } else {
        join(waiting, i);
        waiting = kNobody;
      }
    }
  }

  /// Joins free nodes without neighbours along a Morton curve.
  void join_isolated() {
    std::vector<std::pair<std::uint64_t, std::uint32_t>> isolated;
    for (std::uint32_t i = 0; i < mates_.size(); ++i)
      if (is_free(i) && level_.graph.degree(i) == 0)
        isolated.emplace_back(morton_code(level_.nodes[i].place), i);
    std::sort(isolated.begin(), isolated.end());
    for (std::size_t k = 0; k + 1 < isolated.size(); k += 2) join(isolated[k].second, isolated[k + 1].second);
  }

 private:
  bool is_free(std::uint32_t i) const noexcept { return mates_[i] == i; }
  void join(std::uint32_t i, std::uint32_t j) noexcept {
    mates_[i] = j;
    mates_[j] = i;
  }

  /// The cheapest free neighbour is that of before, as long as it is free.
  void choose(std::uint32_t i) noexcept {
    std::uint32_t& choice = choices_[i];
    if (choice == kNobody || (choice != i && is_free(choice))) return;
    choice = cheapest(i, [&](std::uint32_t j) { return is_free(j); });
  }

  /// Of equal ones the first in the list. Without branches, half of which would go wrong.
  template <class Allows>
  std::uint32_t cheapest(std::uint32_t i, Allows allows) const noexcept {
    static_assert(kMostHaarNeighbors <= 1U << kPlaceBits);
    constexpr std::uint32_t kNever = std::numeric_limits<std::uint32_t>::max();
    const HaarNode& node = level_.nodes[i];
    const auto neighbors = level_.graph.of(i);
    std::uint32_t least = kNever;
    for (std::uint32_t k = 0; k < neighbors.size(); ++k) {
      const std::uint32_t j = neighbors[k];
      const HaarNode& other = level_.nodes[j];
      const std::uint32_t cost = log_class<8>(squared_distance(node.place, other.place) + 1) +
                                 log_class<8>(std::uint64_t{node.weight} + other.weight);
      least = std::min(least, (cost << kPlaceBits | k) | (allows(j) ? 0 : kNever));
    }
    return least == kNever ? kNobody : neighbors[least & ((1U << kPlaceBits) - 1)];
  }
  static constexpr unsigned kPlaceBits = 4;  ///< in the list; costs have less than 16 bits

  static std::uint64_t morton_code(const HaarPlace& place) noexcept {
    std::uint64_t code = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      code |= spread(static_cast<std::uint32_t>(place[axis])) << axis;
    return code;
  }
  /// Bit i at 3 i, of 21 bits.
  static std::uint64_t spread(std::uint64_t x) noexcept {
    x = (x | x << 32) & 0x1f00000000ffff;
    x = (x | x << 16) & 0x1f0000ff0000ff;
    x = (x | x << 8) & 0x100f00f00f00f00f;
    x = (x | x << 4) & 0x10c30c30c30c30c3;
    return (x | x << 2) & 0x1249249249249249;
  }

  const HaarLevel& level_;
  LargeVector<std::uint32_t> mates_;
  LargeVector<std::uint32_t> choices_;  ///< itself: not looked for
};

}  // namespace

LargeVector<std::uint32_t> pair_nodes(const HaarLevel& level) {
  Pairing pairing(level);
  for (int round = 0; round < kChoiceRounds; ++round) pairing.join_mutual_choices();
  pairing.join_in_order();
  pairing.join_rivals();
  pairing.join_isolated();
  return pairing.take();
}

}  // namespace deltamesh
