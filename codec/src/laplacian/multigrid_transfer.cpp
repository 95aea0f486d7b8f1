// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/multigrid_transfer.h"

#include <algorithm>

namespace deltamesh::multigrid {
namespace {

/// A neighbour that is a seed knows its aggregate's value better than one that is not.
constexpr float kSeedWeight = 5;

/// The three largest of the weights offered, the first offered among equals.
class LargestThree {
 public:
  void offer(std::uint32_t node, float weight) noexcept {
    std::size_t place = 3;
    while (place > 0 && weight > weight_[place - 1]) --place;
    if (place == 3) return;
    for (std::size_t k = 2; k > place; --k) {
      node_[k] = node_[k - 1];
      weight_[k] = weight_[k - 1];
    }
    node_[place] = node;
    weight_[place] = weight;
  }

  Interpolation normalized() const noexcept {
    const float scale = 1.0F / (weight_[0] + weight_[1] + weight_[2]);
    Interpolation result;
    for (std::size_t k = 0; k < 3; ++k) {
      result.node[k] = weight_[k] > 0 ? node_[k] : node_[0];
      result.weight[k] = scale * weight_[k];
    }
    return result;
  }

 private:
  std::array<std::uint32_t, 3> node_{};
  std::array<float, 3> weight_{};
};

Row interpolate(const Interpolation& p, std::span<const Row> coarse) noexcept {
  const Row& a = coarse[p.node[0]];
  const Row& b = coarse[p.node[1]];
  const Row& c = coarse[p.node[2]];
  return {p.weight[0] * a.x + p.weight[1] * b.x + p.weight[2] * c.x,
          p.weight[0] * a.s + p.weight[1] * b.s + p.weight[2] * c.s};
}

}  // namespace

std::vector<Interpolation> make_interpolation(const Level& fine, const Aggregates& aggregates) {
  std::vector<Interpolation> result(fine.node_count());
  std::vector<float> sums(aggregates.seeds.size(), 0.0F);
  std::vector<std::uint32_t> touched;
  for (std::uint32_t node = 0; node < result.size(); ++node) {
    LargestThree largest;
    if (aggregates.seeds[aggregates.of[node]] == node) {
      largest.offer(aggregates.of[node], 1.0F);
    } else {
      touched.clear();
      for (std::uint32_t e = fine.offsets[node]; e < fine.offsets[node + 1]; ++e) {
        const std::uint32_t neighbor = fine.neighbors[e];
        const std::uint32_t other = aggregates.of[neighbor];
        if (sums[other] == 0) touched.push_back(other);
        sums[other] += aggregates.seeds[other] == neighbor ? kSeedWeight * fine.weight(e) : fine.weight(e);
      }
      for (const std::uint32_t other : touched) {
        largest.offer(other, sums[other]);
        sums[other] = 0;
      }
    }
    result[node] = largest.normalized();
  }
  return result;
}

void restrict_rows(const Level& level, std::span<const Row> fine, std::span<Row> coarse) {
  std::fill(coarse.begin(), coarse.end(), Row{});
  for (std::size_t i = 0; i < fine.size(); ++i) restrict_row(level.interpolation[i], fine[i], coarse);
}

void prolong_rows(const Level& level, std::span<const Row> coarse, std::span<Row> fine) {
  for (std::size_t i = 0; i < fine.size(); ++i) fine[i] = interpolate(level.interpolation[i], coarse);
}

void add_prolonged_rows(const Level& level, std::span<const Row> coarse, std::span<Row> fine) {
  for (std::size_t i = 0; i < fine.size(); ++i) {
    const Row correction = interpolate(level.interpolation[i], coarse);
    fine[i].x += correction.x;
    fine[i].s += correction.s;
  }
}

}  // namespace deltamesh::multigrid
