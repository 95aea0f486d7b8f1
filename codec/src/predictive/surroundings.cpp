// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "predictive/surroundings.h"

#include <algorithm>

namespace deltamesh {
namespace {

constexpr std::uint32_t kNone = 0xffffffff;

[[gnu::always_inline]] inline void add_neighbor(Surroundings& around, std::uint32_t vertex,
                                                std::uint32_t neighbor) noexcept {
  const unsigned count = around.neighbor_count;
  if (neighbor >= vertex || count == Surroundings::kMostNeighbors) return;
  // Without branches on what is known already, which would often go wrong.
  unsigned known = 0;
  for (unsigned i = 0; i < count; ++i) known |= around.neighbors[i] == neighbor ? 1U : 0U;
  around.neighbors[count] = neighbor;
  around.neighbor_count = count + (known ^ 1U);
}

/// The third corner of the first face at `b` that has the edge a - b and comes before `vertex`, if it is
/// among the first ones.
std::uint32_t find_opposite(const FaceStars& stars, std::uint32_t a, std::uint32_t b,
                            std::uint32_t vertex) noexcept {
  const auto wings = stars.of(b);
  for (const FaceStars::Wing& wing :
       wings.first(std::min<std::size_t>(wings.size(), Surroundings::kMostOpposites))) {
    if (wing.next != a && wing.previous != a) continue;
    const std::uint32_t third = wing.next == a ? wing.previous : wing.next;
    if (third < vertex && third != a && third != b) return third;
  }
  return kNone;
}

}  // namespace

FaceStars::FaceStars(std::span<const std::uint32_t> triangles, std::uint32_t vertex_count)
    : offsets_(std::size_t{vertex_count} + 1), wings_(triangles.size()) {
  for (const std::uint32_t v : triangles) ++offsets_[v];
  std::uint32_t sum = 0;
  for (std::uint32_t& offset : offsets_) {
    sum += offset;
    offset = sum;
  }
  // Filled from the last face to the first, so that every offset ends where its run begins.
  for (std::size_t f = triangles.size(); f > 0; f -= 3) {
    const std::uint32_t* corner = triangles.data() + f - 3;
    wings_[--offsets_[corner[2]]] = {corner[0], corner[1]};
    wings_[--offsets_[corner[1]]] = {corner[2], corner[0]};
    wings_[--offsets_[corner[0]]] = {corner[1], corner[2]};
  }
}

Surroundings look_around(const FaceStars& stars, std::uint32_t vertex) noexcept {
  Surroundings around;
  const auto wings = stars.of(vertex);
  around.faces = static_cast<std::uint32_t>(wings.size());
  for (const FaceStars::Wing& wing : wings) {
    const auto& [a, b] = wing;
    add_neighbor(around, vertex, a);
    add_neighbor(around, vertex, b);
    if (a >= vertex || b >= vertex || a == b || around.known_count == Surroundings::kMostEdges) continue;
    around.known[around.known_count++] = wing;
    if (around.parallelogram_count == Surroundings::kMostParallelograms) continue;
    const auto [low, high] = std::minmax(a, b);
    const std::uint32_t opposite = find_opposite(stars, low, high, vertex);
    if (opposite != kNone) around.parallelograms[around.parallelogram_count++] = {a, b, opposite};
  }
  return around;
}

}  // namespace deltamesh
