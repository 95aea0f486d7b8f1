// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "predictive/surroundings.h"

namespace deltamesh {

KnownFaces::KnownFaces(const FaceList& list, std::span<const std::uint32_t> order)
    : stars_(list.vertex_count) {
  const std::uint32_t* const triangles = list.triangles.data();
  if (order.empty()) {
    for (std::size_t i = 0; i < list.triangles.size(); i += 3)
      add({triangles[i], triangles[i + 1], triangles[i + 2]});
    return;
  }
  std::vector<std::uint32_t> place(order.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) place[order[i]] = i;
  for (std::size_t i = 0; i < list.triangles.size(); i += 3)
    add({place[triangles[i]], place[triangles[i + 1]], place[triangles[i + 2]]});
}

[[gnu::always_inline]] inline void KnownFaces::add(const std::array<std::uint32_t, 3>& corners) noexcept {
  for (const std::uint32_t corner : corners) {
    Star& star = stars_[corner];
    star.faces = static_cast<std::uint8_t>(star.faces + (star.faces < Surroundings::kMostFaces ? 1 : 0));
  }
  // Which corner is the last one is hard to guess: found without a branch.
  constexpr std::array<std::uint8_t, 3> kNext = {1, 2, 0};
  std::size_t last = corners[1] > corners[0] ? 1 : 0;
  last = corners[2] > corners[last] ? 2 : last;
  const std::size_t next = kNext[last];
  const std::uint32_t vertex = corners[last];
  const std::uint32_t a = corners[next];
  const std::uint32_t b = corners[kNext[next]];
  if (a == b || a == vertex || b == vertex) return;
  Star& star = stars_[vertex];
  if (star.known == Surroundings::kMostKnown) return;
  star.a[star.known] = a;
  star.b[star.known] = b;
  ++star.known;
}

}  // namespace deltamesh
