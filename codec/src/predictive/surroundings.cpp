// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "predictive/surroundings.h"

#include <algorithm>

namespace deltamesh {

std::size_t KnownFaces::count_with_faces(std::span<const std::uint32_t> triangles) const noexcept {
  // From the end, where the last vertex mostly is.
  constexpr std::size_t kAtOnce = 1536;
  std::size_t count = 0;
  for (std::size_t end = triangles.size(); end > 0 && count < vertex_count_;) {
    const std::size_t begin = end - std::min(end, kAtOnce);
    std::uint32_t last = 0;
    for (std::size_t i = begin; i < end; ++i) last = std::max(last, triangles[i]);
    count = std::max(count, std::size_t{last} + 1);
    end = begin;
  }
  return count;
}

KnownFaces::KnownFaces(const FaceList& list, std::span<const std::uint32_t> order, std::uint32_t second_walk)
    : vertex_count_(list.vertex_count), second_walk_(second_walk) {
  if (second_walk == kNoVertex) {
    add_all<false>(list, order);
  } else {
    add_all<true>(list, order);
  }
}

template <bool kTwoWalks>
void KnownFaces::add_all(const FaceList& list, std::span<const std::uint32_t> order) {
  const std::uint32_t* const triangles = list.triangles.data();
  if (order.empty()) {
    stars_.assign(count_with_faces(list.triangles), Star{});
    for (std::size_t i = 0; i < list.triangles.size(); i += 3)
      add<kTwoWalks>({triangles[i], triangles[i + 1], triangles[i + 2]});
    return;
  }
  std::vector<std::uint32_t> place(order.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) place[order[i]] = i;
  const std::size_t with_faces = count_with_faces(list.triangles);
  std::size_t count = order.size();
  while (count > 0 && order[count - 1] >= with_faces) --count;
  stars_.assign(count, Star{});
  for (std::size_t i = 0; i < list.triangles.size(); i += 3)
    add<kTwoWalks>({place[triangles[i]], place[triangles[i + 1]], place[triangles[i + 2]]});
}

template <bool kTwoWalks>
[[gnu::always_inline]] inline void KnownFaces::add(const std::array<std::uint32_t, 3>& corners) noexcept {
  for (const std::uint32_t corner : corners) {
    Star& star = stars_[corner];
    star.faces = static_cast<std::uint8_t>(star.faces + (star.faces < Surroundings::kMostFaces ? 1 : 0));
  }
  // Which corner is the last one is hard to guess: found without a branch.
  constexpr std::array<std::uint8_t, 3> kNext = {1, 2, 0};
  const std::array<std::uint32_t, 3> turns = {turn_of<kTwoWalks>(corners[0]), turn_of<kTwoWalks>(corners[1]),
                                              turn_of<kTwoWalks>(corners[2])};
  std::size_t last = turns[1] > turns[0] ? 1 : 0;
  last = turns[2] > turns[last] ? 2 : last;
  const std::size_t next = kNext[last];
  const std::size_t previous = kNext[next];
  const std::uint32_t a = corners[next];
  const std::uint32_t b = corners[previous];
  if (a == b || turns[next] == turns[last] || turns[previous] == turns[last]) return;
  Star& star = stars_[corners[last]];
  if (star.known == Surroundings::kMostKnown) return;
  star.a[star.known] = a;
  star.b[star.known] = b;
  ++star.known;
}

}  // namespace deltamesh
