// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/settling/make_interpolation.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "laplacian/settling/row_sums.h"

namespace deltamesh::settling {
namespace {

/// What a neighbour that is a seed counts: it knows its aggregate's value better.
constexpr float kSeedWeight = 4;

/// The three aggregates that weigh most, in falling order; where there are fewer, with weight 0.
struct Favorites {
  std::array<std::uint32_t, 3> nodes;
  std::array<float, 3> weights;
};

/// The three that weigh most among aggregates put in, the lower ones among equals.
class Heaviest {
 public:
  void put(std::uint32_t aggregate, float weight) noexcept {
    std::uint64_t key = std::uint64_t{std::bit_cast<std::uint32_t>(weight)} << 32 | ~aggregate;
    for (std::uint64_t& other : keys_) {
      const std::uint64_t lesser = std::min(key, other);
      other = std::max(key, other);
      key = lesser;
    }
  }

  Favorites favorites() const noexcept {
    Favorites result;
    for (std::size_t k = 0; k < 3; ++k) {
      result.nodes[k] = ~static_cast<std::uint32_t>(keys_[k]);
      result.weights[k] = std::bit_cast<float>(static_cast<std::uint32_t>(keys_[k] >> 32));
    }
    return result;
  }

 private:
  std::array<std::uint64_t, 3> keys_{kNothing, kNothing, kNothing};  ///< falling
  static constexpr std::uint64_t kNothing = ~std::uint32_t{0};       ///< aggregate 0 with weight 0
};

/// From up to three nodes, with the weights of the last two in sixteenths.
Interpolation interpolate(const std::array<std::uint32_t, 3>& nodes, std::uint32_t second,
                          std::uint32_t third) noexcept {
  return {{nodes[0], second > 0 ? nodes[1] : nodes[0], third > 0 ? nodes[2] : nodes[0]}, second, third};
}

/// Their weights in sixteenths that add up to 1.
Interpolation rounded(const Favorites& from) noexcept {
  const float sixteenths = 16 / (from.weights[0] + from.weights[1] + from.weights[2]);
  const auto second = static_cast<std::uint32_t>(sixteenths * from.weights[1] + 0.5F);
  const auto third = static_cast<std::uint32_t>(sixteenths * from.weights[2] + 0.5F);
  return interpolate(from.nodes, second, third);
}

/// Of some nodes of a level.
template <bool kHasUnitWeights>
class Interpolator {
 public:
  Interpolator(const Level& fine, const Aggregates& aggregates)
      : fine_(fine), aggregates_(aggregates), table_(aggregates.count()) {}

  /// Of the nodes from `begin` to `end`.
  void make(std::uint32_t begin, std::uint32_t end, std::span<Interpolation> result) {
    const std::uint32_t* const offsets = fine_.offsets.data();
    const std::uint32_t* const codes = aggregates_.codes.data();
    for (std::uint32_t node = begin; node < end; ++node) {
      if (codes[node] >= Aggregates::kSeed) {
        result[node] = Interpolation(aggregates_.of(node));
      } else {
        result[node] = rounded(favorites(offsets[node], offsets[node + 1]));
      }
    }
  }

 private:
  static constexpr std::array kFactors = {1.0F, kSeedWeight};

  float weight(std::size_t edge) const noexcept { return kHasUnitWeights ? 1.0F : fine_.weights[edge]; }

  Favorites favorites(std::size_t begin, std::size_t end) {
    const std::uint32_t* const neighbors = fine_.neighbors.data();
    const std::uint32_t* const codes = aggregates_.codes.data();
    RowSums sums = table_.row(end - begin);
    for (std::size_t e = begin; e < end; ++e) {
      const std::uint32_t code = codes[neighbors[e]];
      sums.add(code % Aggregates::kSeed, kFactors[code / Aggregates::kSeed] * weight(e));
    }
    Heaviest heaviest;
    for (const std::uint32_t aggregate : sums.columns()) heaviest.put(aggregate, sums.take(aggregate));
    return heaviest.favorites();
  }

  const Level& fine_;
  const Aggregates& aggregates_;
  SumTable table_;  ///< by aggregates
};

}  // namespace

LargeVector<Interpolation> make_interpolation(const Level& fine, const Aggregates& aggregates) {
  LargeVector<Interpolation> result(fine.node_count());
  if (fine.has_unit_weights())
    Interpolator<true>(fine, aggregates).make(0, fine.node_count(), result);
  else
    Interpolator<false>(fine, aggregates).make(0, fine.node_count(), result);
  return result;
}

}  // namespace deltamesh::settling
