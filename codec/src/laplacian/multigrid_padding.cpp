// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/multigrid_padding.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>

#include "base/four_ints.h"
#include "base/thread_team.h"

namespace deltamesh::multigrid {
namespace {

std::uint32_t padded(std::uint32_t edges) noexcept {
  return (edges + kEdgesAtOnce - 1) / kEdgesAtOnce * kEdgesAtOnce;
}

static_assert(kEdgesAtOnce == 4);

/// Rows before and after.
struct Halves {
  const std::uint32_t* old_neighbors;
  const float* old_weights;
  std::uint32_t old_count;
  std::uint32_t* neighbors;
  float* weights;

  /// The edges from `begin` to `end`, from `to` on; returns where they end there. Four at once: a branch for
  /// each could not be predicted.
  std::uint32_t put(std::uint32_t begin, std::uint32_t end, std::uint32_t to) const noexcept {
    for (std::uint32_t first = begin; first < end; first += kEdgesAtOnce, to += kEdgesAtOnce) {
      const auto left = static_cast<std::int32_t>(end - first);
      const FourInts is_none = FourInts{0, 1, 2, 3} >= left;
      const auto last = static_cast<std::int32_t>(old_neighbors[end - 1]);
      store((load(old_neighbors, first) & ~is_none) | (is_none & last), neighbors + to);
      store(load(old_weights, first) & ~is_none, weights + to);
    }
    return to;
  }

 private:
  /// Zeros beyond the last.
  template <class Value>
  FourInts load(const Value* values, std::uint32_t first) const noexcept {
    FourInts four{};
    if (old_count - first >= kEdgesAtOnce) {
      std::memcpy(&four, values + first, sizeof(four));
    } else {
      std::memcpy(&four, values + first, (old_count - first) * sizeof(Value));
    }
    return four;
  }

  static void store(FourInts four, void* to) noexcept { std::memcpy(to, &four, sizeof(four)); }
};

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
  const Halves halves{old.neighbors.data(), old_weights.data(), old.offsets.back(),
                      level.storage.neighbors.data(), level.weights.data()};
  share_each(nodes, [&, halves](std::uint32_t i) {
    const std::uint32_t to = halves.put(old.offsets[i], level.middle[i], offsets[i]);
    halves.put(std::exchange(level.middle[i], to), old.offsets[i + 1], to);
  });
  level.offsets = level.storage.offsets;
  level.neighbors = level.storage.neighbors;
}

}  // namespace deltamesh::multigrid
