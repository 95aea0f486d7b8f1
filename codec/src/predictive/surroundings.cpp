// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "predictive/surroundings.h"

#include <algorithm>

namespace deltamesh {
namespace {

/// Without a branch, which often would go wrong.
constexpr std::uint32_t choose(bool is_so, std::uint32_t then, std::uint32_t otherwise) noexcept {
  return otherwise ^ ((then ^ otherwise) & (0U - static_cast<std::uint32_t>(is_so)));
}

}  // namespace

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
  if (order.empty()) {
    add_all(list.triangles);
    return;
  }
  std::vector<std::uint32_t> place(order.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) place[order[i]] = i;
  std::vector<std::uint32_t> placed(list.triangles.begin(), list.triangles.end());
  for (std::uint32_t& v : placed) v = place[v];
  add_all(placed);
}

void KnownFaces::add_all(std::span<const std::uint32_t> triangles) {
  stars_.assign(count_with_faces(triangles), Star{});
  Star* const stars = stars_.data();
  const std::uint32_t second_walk = second_walk_;
  for (std::size_t i = 0; i < triangles.size(); i += 3) {
    const std::uint32_t x = triangles[i];
    const std::uint32_t y = triangles[i + 1];
    const std::uint32_t z = triangles[i + 2];
    for (const std::uint32_t corner : {x, y, z}) ++stars[corner].faces;
    const bool is_y = y > x;
    const std::uint32_t later = choose(is_y, y, x);
    const bool is_z = z > later;
    const std::uint32_t last = choose(is_z, z, later);
    const std::uint32_t a = choose(is_z, x, choose(is_y, z, y));
    const std::uint32_t b = x ^ y ^ z ^ a ^ last;
    if (last >= second_walk && ((a < second_walk) | (b < second_walk))) [[unlikely]] {
      add_across_walks({x, y, z});
    } else if (a != b && a != last && b != last) [[likely]] {
      stars[last].add(a, b);
    }
  }
}

/// A face with corners in both walks.
void KnownFaces::add_across_walks(const std::array<std::uint32_t, 3>& corners) noexcept {
  for (std::size_t last = 0; last < 3; ++last) {
    const std::uint32_t a = corners[(last + 1) % 3];
    const std::uint32_t b = corners[(last + 2) % 3];
    const std::uint32_t turn = turn_of(corners[last]);
    if (a != b && turn_of(a) < turn && turn_of(b) < turn) stars_[corners[last]].add(a, b);
  }
}

}  // namespace deltamesh
