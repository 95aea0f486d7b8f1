// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/multigrid_make_interpolation.h"

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

/// Their weights in sixteenths that add up to 1.
Interpolation rounded(const Favorites& from) noexcept {
  const float sixteenths = 16 / (from.weights[0] + from.weights[1] + from.weights[2]);
  const auto second = static_cast<std::uint32_t>(sixteenths * from.weights[1] + 0.5F);
  const auto third = static_cast<std::uint32_t>(sixteenths * from.weights[2] + 0.5F);
  return {{from.nodes[0], from.nodes[second > 0 ? 1 : 0], from.nodes[third > 0 ? 2 : 0]}, second, third};
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
  return {{from.nodes[0], from.nodes[second > 0 ? 1 : 0], from.nodes[third > 0 ? 2 : 0]}, second, third};
}

/// Of some nodes of a level.
class Interpolator {
 public:
  Interpolator(const Level& fine, const Aggregates& aggregates)
      : fine_(fine),
        aggregates_(aggregates),
        are_too_many_(aggregates.count() > FewUnitNeighbors::kMostNodes),
        sums_(aggregates.count(), 0.0F) {}

  Interpolation of(std::uint32_t node) {
    if (aggregates_.is_seed(node)) return Interpolation(aggregates_.of(node));
    if (!FewCodes::can_read(fine_, node) || are_too_many_)
      return rounded(of_many(fine_.offsets[node], fine_.offsets[node + 1]));
    const FewCodes codes(fine_, node, aggregates_.codes.data());
    if (fine_.has_unit_weights()) return rounded(FewUnitNeighbors(codes).favorites());
    const float* const weights = fine_.weights.data() + fine_.offsets[node];
    return rounded(FewNeighbors(codes, weights, kSeedWeight).favorites());
  }

 private:
  Favorites of_many(std::uint32_t begin, std::uint32_t end) {
    touched_.clear();
    for (std::uint32_t e = begin; e < end; ++e) {
      const std::uint32_t neighbor = fine_.neighbors[e];
      float& sum = sums_[aggregates_.of(neighbor)];
      if (sum == 0) touched_.push_back(aggregates_.of(neighbor));
      sum += (aggregates_.is_seed(neighbor) ? kSeedWeight : 1) * fine_.weight(e);
    }
    return take_favorites(touched_, sums_);
  }

  const Level& fine_;
  const Aggregates& aggregates_;
  bool are_too_many_;
  LargeVector<float> sums_;             ///< by aggregates; 0 between nodes
  std::vector<std::uint32_t> touched_;  ///< aggregates with a sum
};

}  // namespace

LargeVector<Interpolation> make_interpolation(const Level& fine, const Aggregates& aggregates) {
  LargeVector<Interpolation> result(fine.node_count());
  share_rows(result.size(), [&](std::uint32_t begin, std::uint32_t end) {
    Interpolator interpolator(fine, aggregates);
    for (std::uint32_t node = begin; node < end; ++node) result[node] = interpolator.of(node);
  });
  return result;
}

}  // namespace deltamesh::multigrid
