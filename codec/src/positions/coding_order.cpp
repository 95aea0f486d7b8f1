// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "positions/coding_order.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>

#include "base/small_code.h"

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

/// Any order but kAsDecoded.
class Placement {
 public:
  /// `known` is told of every vertex and its known faces.
  Placement(const FaceList& list, CodingOrder coding_order, KnownFaces& known)
      : stars_(list),
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
    const std::span<const FaceStars::Wing> wings = stars_.of(v);
    places_[v] = now;
    known_.begin(now, static_cast<std::uint32_t>(wings.size()));
    for (const FaceStars::Wing& wing : wings) {
      const bool has_next = faces_[wing.next] == kPlaced;
      const bool has_previous = faces_[wing.previous] == kPlaced;
      if (has_next && has_previous) {
        known_.add({now, places_[wing.next], places_[wing.previous]});
      } else if (has_next) {
        rise(wing.previous);
      } else if (has_previous) {
        rise(wing.next);
      }
    }
  }

  void rise(std::uint32_t v) {
    if (faces_[v] < WaitingVertices::kClasses) waiting_.add(v, ++faces_[v]);
  }

  FaceStars stars_;
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
