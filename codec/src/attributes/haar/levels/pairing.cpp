// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "attributes/haar/levels/pairing.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "attributes/haar/log_class.h"
#include "base/small_code.h"

namespace deltamesh {
namespace {

constexpr std::uint32_t kNobody = HaarChildren::kNone;
constexpr int kChoiceRounds = 2;  ///< of mutual choices

constexpr unsigned kPlaceBits = 4;  ///< in a list of neighbours
constexpr std::uint32_t kPlaceMask = (1U << kPlaceBits) - 1;
static_assert(kMostHaarNeighbors <= 1U << kPlaceBits);

/// Of every neighbour in the lists what it costs to join it, and below that, in kPlaceBits, its place in the
/// list: so costs are compared, and of equal ones places.
LargeVector<std::uint32_t> joining_costs(const HaarLevel& level) {
  LargeVector<std::uint32_t> costs(level.graph.neighbors.size());
  in_turns(static_cast<std::uint32_t>(level.nodes.size()), [&](std::uint32_t begin, std::uint32_t end) {
    std::uint32_t* next = costs.data() + level.graph.offsets[begin];
    for (std::uint32_t i = begin; i < end; ++i) {
      // With the weight turned round, the difference to another node has the sum of the weights.
      constexpr FourInts kWeight = {0, 0, 0, -1};
      const FourInts node = (level.nodes[i].lanes() ^ kWeight) - kWeight;
      std::uint32_t place = 0;
      for (const std::uint32_t j : level.graph.of(i)) {
        const FourInts difference = level.nodes[j].lanes() - node;
        const double weight = low_doubles(pick_lanes<2, 3, 2, 3>(difference))[1];
        const std::uint32_t cost = log_class<8>(squared_distance(difference) + 1) + log_class<8>(weight);
        *next++ = cost << kPlaceBits | place++;
      }
    }
  });
  return costs;
}

class Pairing {
 public:
  explicit Pairing(const HaarLevel& level)
      : level_(level),
        costs_(joining_costs(level)),
        mates_(level.nodes.size()),
        choices_(level.nodes.size() + 1),
        free_(level.nodes.size()) {
    for (std::uint32_t i = 0; i < mates_.size(); ++i) mates_[i] = choices_[i] = free_[i] = i;
    choices_.back() = kNobody;
  }

  LargeVector<std::uint32_t> take() noexcept { return std::move(mates_); }

  /// Joins nodes each of which is the other's cheapest free neighbour.
  void join_mutual_choices() {
    for (const std::uint32_t i : free_) choose(i);
    const auto nobody = static_cast<std::uint32_t>(mates_.size());
    for (const std::uint32_t i : free_) {
      const std::uint32_t j = choices_[i];
      const bool is_mutual = choices_[std::min(j, nobody)] == i;
      mates_[i] =
          i ^ ((i ^ j) & (0U - (is_mutual ? 1U : 0U)));  // without a branch, which would often go wrong
    }
    forget_joined();
  }

  /// Joins each free node in order with its cheapest free neighbour.
  void join_in_order() {
    for (const std::uint32_t i : free_) {
      if (!is_free(i)) continue;
      choose(i);
      if (choices_[i] != kNobody) join(i, choices_[i]);
    }
    forget_joined();
  }

  /// Joins free nodes whose cheapest neighbour is the same, which leaves one of them at most: that all
  /// neighbours of one node wait for it would take as many levels as there are neighbours.
  void join_rivals() {
    LargeVector<std::uint32_t> waiting_for(mates_.size(), kNobody);
    for (const std::uint32_t i : free_) {
      const std::uint32_t j = cheapest(i, [](std::uint32_t) { return 0U; });
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
    for (const std::uint32_t i : free_)
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

  void forget_joined() {
    std::size_t count = 0;
    for (const std::uint32_t i : free_) {
      free_[count] = i;
      count += is_free(i) ? 1 : 0;
    }
    free_.resize(count);
  }

  /// The cheapest free neighbour is that of before, as long as it is free.
  void choose(std::uint32_t i) noexcept {
    std::uint32_t& choice = choices_[i];
    if (choice == kNobody || (choice != i && is_free(choice))) return;
    choice = cheapest(i, [&](std::uint32_t j) { return mates_[j] ^ j; });
  }

  /// `bar`: 0 of nodes that may be chosen. Without branches, half of which would go wrong: what bars a node
  /// is above its cost.
  template <class Bar>
  std::uint32_t cheapest(std::uint32_t i, Bar bar) const noexcept {
    constexpr unsigned kBarShift = 32;
    const auto neighbors = level_.graph.of(i);
    const std::uint32_t* const costs = costs_.data() + level_.graph.offsets[i];
    std::uint64_t least = std::uint64_t{1} << kBarShift;
    // Four at once, the last again and again: most lists take two turns.
    for (std::size_t begin = 0; begin < neighbors.size(); begin += 4) {
      for (std::size_t k = begin; k < begin + 4; ++k) {
        const std::size_t place = std::min(k, neighbors.size() - 1);
        least = std::min(least, std::uint64_t{bar(neighbors[place])} << kBarShift | costs[place]);
      }
    }
    return least >> kBarShift != 0 ? kNobody : neighbors[least & kPlaceMask];
  }

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
  LargeVector<std::uint32_t> costs_;  ///< by place in the graph
  LargeVector<std::uint32_t> mates_;
  LargeVector<std::uint32_t> choices_;  ///< itself: not looked for; one more of nobody
  LargeVector<std::uint32_t> free_;     ///< in order; some may have been joined since
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
