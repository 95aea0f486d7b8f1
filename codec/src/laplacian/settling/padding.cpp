// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/settling/padding.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace deltamesh::settling {
namespace {

std::uint32_t padded(std::uint32_t edges) noexcept {
  return (edges + kEdgesAtOnce - 1) / kEdgesAtOnce * kEdgesAtOnce;
}

static_assert(kEdgesAtOnce == 2);

/// Of every edge, beside each other.
struct Ends {
  std::uint32_t* neighbors;
  float* weights;
};

/// Copies half a row, the edges from `begin` to `end`, to where `to` begins, padded; returns where that ends.
/// The only branches are on the length.
std::uint32_t put_half(Ends from, std::uint32_t begin, std::uint32_t end, Ends into, std::uint32_t to) {
  if (begin == end) return to;
  for (; begin + 2 < end; begin += 2, to += 2) {
    std::copy_n(from.neighbors + begin, 2, into.neighbors + to);
    std::copy_n(from.weights + begin, 2, into.weights + to);
  }
  into.neighbors[to] = from.neighbors[begin];
  into.weights[to] = from.weights[begin];
  into.neighbors[to + 1] = from.neighbors[end - 1];
  into.weights[to + 1] = begin + 1 == end ? 0 : from.weights[end - 1];
  return to + 2;
}

}  // namespace

void pad_rows(Level& level) {
  const std::uint32_t nodes = level.node_count();
  Adjacency old = std::exchange(level.storage, {});
  LargeVector<float> old_weights = std::exchange(level.weights, {});
  LargeVector<std::uint32_t>& offsets = level.storage.offsets;
  offsets.resize(nodes + 1);
  std::uint32_t count = 0;
  for (std::uint32_t i = 0; i < nodes; ++i) {
    offsets[i] = count;
    count += padded(level.middle[i] - old.offsets[i]) + padded(old.offsets[i + 1] - level.middle[i]);
  }
  offsets[nodes] = count;
  level.storage.neighbors.resize(count);
  level.weights.resize(count);
  const Ends from{old.neighbors.data(), old_weights.data()};
  const Ends into{level.storage.neighbors.data(), level.weights.data()};
  for (std::uint32_t i = 0; i < nodes; ++i) {
    const std::uint32_t middle = put_half(from, old.offsets[i], level.middle[i], into, offsets[i]);
    put_half(from, level.middle[i], old.offsets[i + 1], into, middle);
    level.middle[i] = middle;
  }
  level.offsets = level.storage.offsets;
  level.neighbors = level.storage.neighbors;
}

}  // namespace deltamesh::settling
