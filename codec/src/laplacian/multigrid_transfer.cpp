// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/multigrid_transfer.h"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

#include "base/thread_team.h"

namespace deltamesh::multigrid {
namespace {

/// Of a neighbour, and of one that is a seed: that knows its aggregate's value better.
constexpr std::array<float, 2> kWeights = {1, 4};

/// The three largest of the weights offered, the first offered among equals. Without branches, which could
/// not be predicted.
class LargestThree {
 public:
  /// `weight`: not below 0; `place`: rises from one offer to the next.
  void offer(std::uint32_t place, float weight) noexcept {
    std::uint64_t key = (std::uint64_t{std::bit_cast<std::uint32_t>(weight)} << 32) | ~place;
    for (std::uint64_t& kept : keys_) {
      const std::uint64_t changes = (kept ^ key) & (0 - std::uint64_t{key > kept ? 1U : 0U});
      kept ^= changes;
      key ^= changes;
    }
  }

  /// `nodes`: by place.
  Interpolation interpolation(std::span<const std::uint32_t> nodes) const noexcept {
    std::array<float, 3> weights{};
    for (std::size_t k = 0; k < 3; ++k)
      weights[k] = std::bit_cast<float>(static_cast<std::uint32_t>(keys_[k] >> 32));
    const float sixteenths = 16 / (weights[0] + weights[1] + weights[2]);
    const auto second = static_cast<std::uint32_t>(sixteenths * weights[1] + 0.5F);
    const auto third = static_cast<std::uint32_t>(sixteenths * weights[2] + 0.5F);
    const auto node = [&](std::size_t k) { return nodes[~static_cast<std::uint32_t>(keys_[k])]; };
    return {{node(0), node(second > 0 ? 1 : 0), node(third > 0 ? 2 : 0)}, second, third};
  }

 private:
  std::array<std::uint64_t, 3> keys_{};
};

void interpolate_nodes(const Level& fine, const Aggregates& aggregates, std::uint32_t begin,
                       std::uint32_t end, LargeVector<Interpolation>& result) {
  LargeVector<float> sums(aggregates.count(), 0.0F);
  LargeVector<std::uint32_t> touched(aggregates.count() + 1);
  for (std::uint32_t node = begin; node < end; ++node) {
    if (aggregates.is_seed(node)) {
      result[node] = Interpolation(aggregates.of(node));
      continue;
    }
    std::uint32_t count = 0;
    for (std::uint32_t e = fine.offsets[node]; e < fine.offsets[node + 1]; ++e) {
      const std::uint32_t neighbor = fine.neighbors[e];
      float& sum = sums[aggregates.of(neighbor)];
      touched[count] = aggregates.of(neighbor);
      count += sum == 0 ? 1 : 0;
      sum += kWeights[aggregates.is_seed(neighbor) ? 1 : 0] * fine.weight(e);
    }
    LargestThree largest;
    for (std::uint32_t k = 0; k < count; ++k) largest.offer(k, std::exchange(sums[touched[k]], 0.0F));
    result[node] = largest.interpolation(touched);
  }
}

}  // namespace

LargeVector<Interpolation> make_interpolation(const Level& fine, const Aggregates& aggregates) {
  LargeVector<Interpolation> result(fine.node_count());
  share_rows(result.size(), [&](std::uint32_t begin, std::uint32_t end) {
    interpolate_nodes(fine, aggregates, begin, end, result);
  });
  return result;
}

void restrict_rows(const Level& level, std::span<const Row> fine, std::span<Row> coarse) {
  share_each(coarse.size(), [&](std::uint32_t i) { coarse[i] = Row{}; });
  level.chunks.visit([&](std::uint32_t i) {
    level.interpolation[i].spread(fine[i], [&](std::uint32_t node) -> Row& { return coarse[node]; });
  });
}

void prolong_rows(const Level& level, std::span<const Row> coarse, std::span<Row> fine) {
  share_each(fine.size(), [&](std::uint32_t i) { fine[i] = level.interpolation[i].of(coarse); });
}

void add_prolonged_rows(const Level& level, std::span<const Row> coarse, std::span<Row> fine) {
  share_each(fine.size(), [&](std::uint32_t i) { fine[i] += level.interpolation[i].of(coarse); });
}

}  // namespace deltamesh::multigrid
