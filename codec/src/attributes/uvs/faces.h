// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The part of the predictions of texture coordinates that depends on faces and positions only: the place of a
// face's last corner relative to the edge between the other two, and the face across that edge [ATTR-32].
// Computed for several faces at a time, so that divisions and square roots overlap. The same bits on every
// machine.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "attributes/surface.h"
#include "attributes/surface_order.h"

namespace deltamesh {

inline constexpr std::uint32_t kNoUvVertex = std::numeric_limits<std::uint32_t>::max();

/// A face over the edge from `a` to `b`. Places are edge * x + height * y, the edge being 1.
struct UvFace {
  std::uint32_t a;
  std::uint32_t b;
  std::uint32_t across;  ///< third corner of the face across the edge, if that is known; or kNoUvVertex
  bool counts;           ///< its last corner is not out of all proportion
  bool goes_on;          ///< nor is `across`, which is known
  double x;              ///< of the last corner
  double y;
  double weight;
  // For the prediction from the face across:
  double across_x;
  double ratio;          ///< of both faces' heights
  double across_weight;  ///< 0 where that face is too flat
};

class UvFaces {
 public:
  /// Both must outlive this.
  UvFaces(const AttributeSurface& surface, const SurfaceOrder& order);

  /// Those that order.vertices[i] is the last corner of. Valid until the next call; i rises.
  std::span<const UvFace> completed_by(std::size_t i) {
    if (i >= end_) make(i);
    const std::size_t begin = i == 0 ? 0 : order_.ends[i - 1];
    return std::span(faces_).subspan(begin - first_face_, order_.ends[i] - begin);
  }

  /// Whether the vertex comes before order.vertices[i].
  bool is_before(std::uint32_t vertex, std::size_t i) const noexcept { return places_[vertex] < i; }

 private:
  struct Edge;

  void make(std::size_t i);
  void add(std::size_t i, const Corner& corner);
  std::uint32_t find_across(std::size_t i, const Corner& corner) const noexcept;

  const AttributeSurface& surface_;
  const SurfaceOrder& order_;
  const VertexCorners& corners_;
  std::vector<std::uint32_t> places_;  ///< in the surface order, by vertex
  std::vector<UvFace> faces_;          ///< of some vertices, to order.vertices[end_]
  std::size_t first_face_ = 0;         ///< the number of the first of them
  std::size_t end_ = 0;
};

}  // namespace deltamesh
