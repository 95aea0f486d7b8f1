// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "predictive/walk.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

namespace deltamesh {
namespace {

/// Vertices that wait, by how many faces have their two other corners placed: one, two, or more.
class WaitingVertices {
 public:
  static constexpr std::size_t kClasses = 3;

  explicit WaitingVertices(Walk walk) noexcept : walk_(walk) {}

  void add(std::uint32_t vertex, std::size_t faces) { lists_[faces - 1].vertices.push_back(vertex); }

  /// Of those with most faces; a vertex that has gone up or is placed is still listed where it was.
  std::optional<std::uint32_t> take() {
    for (std::size_t i = kClasses; i-- > 0;) {
      List& list = lists_[i];
      if (list.head == list.vertices.size()) continue;
      if (walk_ == Walk::kBroad) return list.vertices[list.head++];
      const std::uint32_t last = list.vertices.back();
      list.vertices.pop_back();
      return last;
    }
    return std::nullopt;
  }

 private:
  struct List {
    std::vector<std::uint32_t> vertices;
    std::size_t head = 0;  ///< of kBroad: those before it are taken
  };

  Walk walk_;
  std::array<List, kClasses> lists_;
};

}  // namespace

std::vector<std::uint32_t> walk_order(const FaceStars& stars, Walk walk) {
  constexpr std::uint8_t kPlaced = 255;
  std::vector<std::uint32_t> order;
  if (walk == Walk::kAsDecoded) return order;
  order.reserve(stars.vertex_count());
  std::vector<std::uint8_t> faces(stars.vertex_count());  // with two placed corners, to kClasses; or kPlaced
  WaitingVertices waiting(walk);
  const auto rise = [&](std::uint32_t v) {
    if (faces[v] < WaitingVertices::kClasses) waiting.add(v, ++faces[v]);
  };
  const auto place = [&](std::uint32_t v) {
    order.push_back(v);
    faces[v] = kPlaced;
    for (const FaceStars::Wing& wing : stars.of(v)) {
      const bool has_next = faces[wing.next] == kPlaced;
      const bool has_previous = faces[wing.previous] == kPlaced;
      if (has_next && !has_previous) rise(wing.previous);
      if (has_previous && !has_next) rise(wing.next);
    }
  };
  for (std::uint32_t start = 0; start < stars.vertex_count(); ++start) {
    if (faces[start] == kPlaced) continue;
    place(start);
    while (const auto next = waiting.take())
      if (faces[*next] != kPlaced) place(*next);
  }
  return order;
}

FaceStars renumber(const FaceStars& stars, const std::vector<std::uint32_t>& order) {
  std::vector<std::uint32_t> place(order.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) place[order[i]] = i;
  std::vector<FaceStars::Wing> wings;
  std::vector<std::uint32_t> offsets{0};
  offsets.reserve(order.size() + 1);
  for (const std::uint32_t vertex : order) {
    for (const FaceStars::Wing& wing : stars.of(vertex))
      wings.push_back({place[wing.next], place[wing.previous]});
    offsets.push_back(static_cast<std::uint32_t>(wings.size()));
  }
  return {std::move(wings), std::move(offsets)};
}

}  // namespace deltamesh
