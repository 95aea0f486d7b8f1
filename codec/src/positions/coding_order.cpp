// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "positions/coding_order.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>

namespace deltamesh {
namespace {

/// The faces at every vertex, in face order, each as its two other corners.
class FaceStars {
 public:
  struct Wing {
    std::uint32_t next;      ///< the corner after the vertex
    std::uint32_t previous;  ///< the corner before it
  };

  explicit FaceStars(const FaceList& list)
      : offsets_(std::size_t{list.vertex_count} + 1), wings_(list.triangles.size()) {
    for (const std::uint32_t v : list.triangles) ++offsets_[v];
    std::uint32_t sum = 0;
    for (std::uint32_t& offset : offsets_) {
      sum += offset;
      offset = sum;
    }
    // Filled from the last face to the first, so that every offset ends where its run begins.
    for (std::size_t f = list.triangles.size(); f > 0; f -= 3) {
      const std::uint32_t* corner = list.triangles.data() + f - 3;
      wings_[--offsets_[corner[2]]] = {corner[0], corner[1]};
      wings_[--offsets_[corner[1]]] = {corner[2], corner[0]};
      wings_[--offsets_[corner[0]]] = {corner[1], corner[2]};
    }
  }

  std::span<const Wing> of(std::uint32_t vertex) const noexcept {
    return {wings_.data() + offsets_[vertex], wings_.data() + offsets_[vertex + 1]};
  }

 private:
  std::vector<std::uint32_t> offsets_;
  std::vector<Wing> wings_;
};

/// Vertices that wait, by how many faces have their two other corners placed: one, two, or more.
class WaitingVertices {
 public:
  static constexpr std::size_t kClasses = 3;

  explicit WaitingVertices(CodingOrder coding_order) noexcept : coding_order_(coding_order) {}

  void add(std::uint32_t vertex, std::size_t faces) { lists_[faces - 1].vertices.push_back(vertex); }

  /// Of those with most faces; a vertex that has gone up or is placed is still listed where it was.
  std::optional<std::uint32_t> take() {
    for (std::size_t i = kClasses; i-- > 0;) {
      List& list = lists_[i];
      if (list.head == list.vertices.size()) continue;
      if (coding_order_ == CodingOrder::kBroad) return list.vertices[list.head++];
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

  CodingOrder coding_order_;
  std::array<List, kClasses> lists_;
};

/// Any order but kAsDecoded. `known` is told of every vertex and its known faces.
std::vector<std::uint32_t> placed_vertices(const FaceList& list, CodingOrder coding_order,
                                           KnownFaces& known) {
  constexpr std::uint8_t kPlaced = 255;
  const FaceStars stars(list);
  std::vector<std::uint32_t> order;
  order.reserve(list.vertex_count);
  std::vector<std::uint32_t> places(list.vertex_count);
  std::vector<std::uint8_t> faces(list.vertex_count);  // with two placed corners, to kClasses; or kPlaced
  WaitingVertices waiting(coding_order);
  const auto rise = [&](std::uint32_t v) {
    if (faces[v] < WaitingVertices::kClasses) waiting.add(v, ++faces[v]);
  };
  const auto place = [&](std::uint32_t v) {
    const auto now = static_cast<std::uint32_t>(order.size());
    order.push_back(v);
    faces[v] = kPlaced;
    const std::span<const FaceStars::Wing> wings = stars.of(v);
    places[v] = now;
    known.begin(now, static_cast<std::uint32_t>(wings.size()));
    for (const FaceStars::Wing& wing : wings) {
      const bool has_next = faces[wing.next] == kPlaced;
      const bool has_previous = faces[wing.previous] == kPlaced;
      if (has_next && has_previous) {
        known.add({now, places[wing.next], places[wing.previous]});
      } else if (has_next) {
        rise(wing.previous);
      } else if (has_previous) {
        rise(wing.next);
      }
    }
  };
  for (std::uint32_t start = 0; start < list.vertex_count; ++start) {
    if (faces[start] == kPlaced) continue;
    place(start);
    while (const auto next = waiting.take())
      if (faces[*next] != kPlaced) place(*next);
  }
  return order;
}

}  // namespace

KnownFaces known_in_order(const FaceList& list, CodingOrder coding_order, std::vector<std::uint32_t>& order) {
  order.clear();
  if (coding_order == CodingOrder::kAsDecoded) return KnownFaces(list);
  KnownFaces known(list.vertex_count, count_with_faces(list));
  order = placed_vertices(list, coding_order, known);
  return known;
}

}  // namespace deltamesh
