// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/multigrid_make_interpolation.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "base/thread_team.h"
#include "laplacian/multigrid_few_neighbors.h"
#include "laplacian/multigrid_few_unit_neighbors.h"

namespace deltamesh::multigrid {
namespace {

/// What a neighbour that is a seed counts: it knows its aggregate's value better.
constexpr float kSeedWeight = FewUnitNeighbors::kSeedWeight;

/// Of the aggregates `touched`, the lower ones among equals. Clears their sums.
Favorites take_favorites(std::span<const std::uint32_t> touched, LargeVector<float>& sums) noexcept {
  Favorites result{};
  for (std::uint32_t aggregate : touched) {
    float weight = std::exchange(sums[aggregate], 0.0F);
    for (std::size_t k = 0; k < 3; ++k) {
      const bool is_equal = weight == result.weights[k];
      if (weight < result.weights[k] || (is_equal && aggregate > result.nodes[k])) continue;
      std::swap(weight, result.weights[k]);
      std::swap(aggregate, result.nodes[k]);
    }
  }
  return result;
}

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

/// `weight` of a sum in sixteenths, for all that FewUnitNeighbors can find.
class Sixteenths {
 public:
  constexpr Sixteenths() {
    for (std::uint32_t sum = 1; sum < kSums; ++sum) {
      for (std::uint32_t weight = 0; weight < kWeights; ++weight)
        of_[sum][weight] = static_cast<std::uint8_t>((32 * weight + sum) / (2 * sum));
    }
  }
  constexpr std::uint32_t operator()(std::uint32_t weight, std::uint32_t sum) const noexcept {
    return of_[sum][weight];
  }

 private:
  static constexpr std::uint32_t kWeights = FewUnitNeighbors::kMostWeight + 1;
  static constexpr std::uint32_t kSums = FewCodes::kMost + 3 * FewUnitNeighbors::kSeedWeight + 1;
  std::array<std::array<std::uint8_t, kWeights>, kSums> of_{};
};
constexpr Sixteenths kSixteenths;

Interpolation rounded(const UnitFavorites& from) noexcept {
  const std::uint32_t sum = from.weights[0] + from.weights[1] + from.weights[2];
  const std::uint32_t second = kSixteenths(from.weights[1], sum);
  const std::uint32_t third = kSixteenths(from.weights[2], sum);
  return interpolate(from.nodes, second, third);
}

/// Of some nodes of a level.
template <bool kHasUnitWeights>
class Interpolator {
 public:
  Interpolator(const Level& fine, const Aggregates& aggregates)
      : fine_(fine),
        aggregates_(aggregates),
        most_few_(aggregates.count() <= FewUnitNeighbors::kMostNodes ? FewCodes::kMost : 0),
        sums_(aggregates.count(), 0.0F) {}

  /// Of the nodes from `begin` to `end`.
  void make(std::uint32_t begin, std::uint32_t end, std::span<Interpolation> result) {
    const std::uint32_t* const offsets = fine_.offsets.data();
    const std::uint32_t* const neighbors = fine_.neighbors.data();
    const std::uint32_t* const codes = aggregates_.codes.data();
    const std::size_t edges = fine_.neighbors.size();
    for (std::uint32_t node = begin; node < end; ++node) {
      const std::size_t first = offsets[node];
      const std::size_t degree = offsets[node + 1] - first;
      if (codes[node] >= Aggregates::kSeed) {
        result[node] = Interpolation(aggregates_.of(node));
      } else if (degree <= most_few_ && first + FewCodes::kMost <= edges) {
        result[node] = of_few(FewCodes(neighbors + first, degree, codes), first);
      } else {
        result[node] = rounded(of_many(first, first + degree));
      }
    }
  }

 private:
  Interpolation of_few(const FewCodes& codes, std::size_t first) const noexcept {
    if constexpr (kHasUnitWeights) return rounded(FewUnitNeighbors(codes).favorites());
    return rounded(FewNeighbors(codes, fine_.weights.data() + first, kSeedWeight).favorites());
  }

  float weight(std::size_t edge) const noexcept { return kHasUnitWeights ? 1.0F : fine_.weights[edge]; }

  Favorites of_many(std::size_t begin, std::size_t end) {
    touched_.clear();
    for (std::size_t e = begin; e < end; ++e) {
      const std::uint32_t neighbor = fine_.neighbors[e];
      float& sum = sums_[aggregates_.of(neighbor)];
      if (sum == 0) touched_.push_back(aggregates_.of(neighbor));
      sum += (aggregates_.is_seed(neighbor) ? kSeedWeight : 1) * weight(e);
    }
    return take_favorites(touched_, sums_);
  }

  const Level& fine_;
  const Aggregates& aggregates_;
  std::size_t most_few_;                ///< neighbours that FewCodes is for; 0 where it is not
  LargeVector<float> sums_;             ///< by aggregates; 0 between nodes
  std::vector<std::uint32_t> touched_;  ///< aggregates with a sum
};

}  // namespace

LargeVector<Interpolation> make_interpolation(const Level& fine, const Aggregates& aggregates) {
  LargeVector<Interpolation> result(fine.node_count());
  share_rows(result.size(), [&](std::uint32_t begin, std::uint32_t end) {
    if (fine.has_unit_weights())
      Interpolator<true>(fine, aggregates).make(begin, end, result);
    else
      Interpolator<false>(fine, aggregates).make(begin, end, result);
  });
  return result;
}

}  // namespace deltamesh::multigrid
