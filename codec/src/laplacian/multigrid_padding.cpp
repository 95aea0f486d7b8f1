// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/multigrid_padding.h"

#include <cstdint>
#include <utility>

#include "base/thread_team.h"

namespace deltamesh::multigrid {
namespace {

std::uint32_t padded(std::uint32_t edges) noexcept {
  return (edges + kEdgesAtOnce - 1) / kEdgesAtOnce * kEdgesAtOnce;
}

}  // namespace

void pad_rows(Level& level) {
  const std::uint32_t nodes = level.node_count();
  const Adjacency old = std::exchange(level.storage, {});
  const LargeVector<float> old_weights = std::exchange(level.weights, {});
  LargeVector<std::uint32_t>& offsets = level.storage.offsets;
  offsets.resize(nodes + 1);
  offsets[0] = 0;
  for (std::uint32_t i = 0; i < nodes; ++i) {
    const std::uint32_t lower = padded(level.middle[i] - old.offsets[i]);
    offsets[i + 1] = offsets[i] + lower + padded(old.offsets[i + 1] - level.middle[i]);
  }
  level.storage.neighbors.resize(offsets[nodes]);
  level.weights.resize(offsets[nodes]);
  share_each(nodes, [&](std::uint32_t i) {
    std::uint32_t to = offsets[i];
    const auto put_half = [&](std::uint32_t begin, std::uint32_t end) {
      const std::uint32_t half_end = to + padded(end - begin);
      for (std::uint32_t e = begin; e < end; ++e, ++to) {
        level.storage.neighbors[to] = old.neighbors[e];
        level.weights[to] = old_weights[e];
      }
      for (; to < half_end; ++to) {
        level.storage.neighbors[to] = old.neighbors[end - 1];
        level.weights[to] = 0;
      }
    };
    put_half(old.offsets[i], level.middle[i]);
    const std::uint32_t middle = std::exchange(level.middle[i], to);
    put_half(middle, old.offsets[i + 1]);
  });
  level.offsets = level.storage.offsets;
  level.neighbors = level.storage.neighbors;
}

}  // namespace deltamesh::multigrid
