// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "positions/coding_order.h"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>

#include "base/small_code.h"
#include "topology/vertex_corners.h"

namespace deltamesh {
namespace {

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

/// Any order but kAsDecoded.
class Placement {
 public:
  /// `known` is told of every vertex and its known faces.
  Placement(const FaceList& list, CodingOrder coding_order, KnownFaces& known)
      : corners_(list.triangles, list.vertex_count),
        known_(known),
        places_(list.vertex_count),
        faces_(list.vertex_count),
        waiting_(coding_order) {
    order_.reserve(list.vertex_count);
  }

  std::vector<std::uint32_t> run() {
    for (std::uint32_t start = 0; start < faces_.size(); ++start) {
      if (faces_[start] == kPlaced) continue;
      place(start);
      while (const auto next = waiting_.take())
        if (faces_[*next] != kPlaced) place(*next);
    }
    return std::move(order_);
  }

 private:
  static constexpr std::uint8_t kPlaced = 255;

  DELTAMESH_LOOP_BODY void place(std::uint32_t v) {
    const auto now = static_cast<std::uint32_t>(order_.size());
    order_.push_back(v);
    faces_[v] = kPlaced;
    const std::span<const Corner> corners = corners_.of(v);
    places_[v] = now;
    known_.begin(now, static_cast<std::uint32_t>(corners.size()));
    for (const Corner& corner : corners) {
      const bool has_next = faces_[corner.next] == kPlaced;
      const bool has_before = faces_[corner.before] == kPlaced;
      if (has_next && has_before) {
        known_.add({now, places_[corner.next], places_[corner.before]});
      } else if (has_next) {
        rise(corner.before);
      } else if (has_before) {
        rise(corner.next);
      }
    }
  }

  void rise(std::uint32_t v) {
    if (faces_[v] < WaitingVertices::kClasses) waiting_.add(v, ++faces_[v]);
  }

  VertexCorners corners_;
  KnownFaces& known_;
  std::vector<std::uint32_t> order_;
  std::vector<std::uint32_t> places_;
  std::vector<std::uint8_t> faces_;  ///< with two placed corners, to kClasses; or kPlaced
  WaitingVertices waiting_;
};

}  // namespace

KnownFaces known_in_order(const FaceList& list, CodingOrder coding_order, std::vector<std::uint32_t>& order) {
  order.clear();
  if (coding_order == CodingOrder::kAsDecoded) return KnownFaces(list);
  KnownFaces known(list.vertex_count, count_with_faces(list));
  order = Placement(list, coding_order, known).run();
  return known;
}

}  // namespace deltamesh
