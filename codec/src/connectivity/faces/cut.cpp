// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "connectivity/faces/cut.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "base/memory/large_vector.h"

namespace deltamesh {
namespace {

/// Finds the opposite half-edges, vertex by vertex: each looks at the edges of which it is the smaller end.
class Matcher {
 public:
  Matcher(std::span<const std::uint32_t> triangles, std::uint32_t vertex_count)
      : triangles_(triangles), heads_(vertex_count, kNoIndex) {
    reserve_large(edges_, vertex_count);
    edges_.resize(vertex_count);
    reserve_large(opposite_, triangles.size());
  }

  HalfEdges match() && {
    link_by_smaller_end();
    for (std::uint32_t v = 0; v < heads_.size(); ++v) match_edges_of(v);
    return {std::move(opposite_), std::move(repeated_), degenerate_};
  }

 private:
  /// A half-edge by its larger end.
  struct Spoke {
    std::uint32_t end;
    std::uint32_t half_edge;
  };
  /// What half-edges there are of an edge, a bit each.
  static constexpr std::uint32_t kInward = 1;  ///< to the smaller end; kMore times it: more than one
  static constexpr std::uint32_t kOutward = 4;
  static constexpr std::uint32_t kMore = 2;
  static constexpr std::uint32_t kPair = kInward | kOutward;
  /// The edge of which a vertex is the larger end.
  struct Edge {
    std::uint32_t smaller_end = kNoIndex;  ///< the last one that looked here; for others there is nothing yet
    std::uint32_t sum = 0;                 ///< of all half-edges, bit by bit
    std::uint32_t kinds = 0;
  };

  std::uint32_t from(std::uint32_t h) const noexcept { return triangles_[h]; }
  std::uint32_t to(std::uint32_t h) const noexcept { return triangles_[next_in_face(h)]; }
  std::uint32_t apex(std::uint32_t h) const noexcept { return triangles_[previous_in_face(h)]; }

  /// Half-edges with the same smaller end become a list, linked through opposite_.
  void link_by_smaller_end() {
    opposite_.resize(triangles_.size());
    const auto link = [this](std::uint32_t h, std::uint32_t a, std::uint32_t b) {
      opposite_[h] = std::exchange(heads_[std::min(a, b)], h);
    };
    for (std::uint32_t first = 0; first < triangles_.size(); first += 3) {
      const std::uint32_t a = triangles_[first];
      const std::uint32_t b = triangles_[first + 1];
      const std::uint32_t c = triangles_[first + 2];
      if (a == b || b == c || c == a) {
        degenerate_ = true;
        for (std::uint32_t k = 0; k < 3; ++k) opposite_[first + k] = kNoIndex;
        continue;
      }
      link(first, a, b);
      link(first + 1, b, c);
      link(first + 2, c, a);
    }
  }

  /// Where an edge has one half-edge of either direction, the sum tells each the other one.
  void match_edges_of(std::uint32_t v) {
    spokes_.clear();
    for (std::uint32_t h = heads_[v]; h != kNoIndex; h = opposite_[h]) {
      const std::uint32_t start = from(h);
      const std::uint32_t end = start ^ to(h) ^ v;
      Edge& edge = edges_[end];
      const std::uint32_t kind = start == v ? kOutward : kInward;
      const std::uint32_t known = edge.smaller_end == v ? ~0U : 0U;
      const std::uint32_t kinds = edge.kinds & known;
      edge = {
          .smaller_end = v, .sum = (edge.sum & known) ^ h, .kinds = kinds | kind | (kinds & kind) * kMore};
      spokes_.push_back({end, h});
    }
    std::uint32_t all_kinds = 0;
    for (const Spoke& spoke : spokes_) {
      const Edge& edge = edges_[spoke.end];
      opposite_[spoke.half_edge] = edge.kinds == kPair ? edge.sum ^ spoke.half_edge : kNoIndex;
      all_kinds |= edge.kinds;
    }
    if ((all_kinds & kPair * kMore) == 0) return;
    match_crowded_edges();
  }

  void match_crowded_edges() {
    std::sort(spokes_.begin(), spokes_.end(), [](const Spoke& a, const Spoke& b) {
      return std::pair(a.end, a.half_edge) < std::pair(b.end, b.half_edge);
    });
    for (std::span<const Spoke> rest = spokes_; !rest.empty();) {
      const Spoke& first = rest.front();
      const auto end =
          std::find_if(rest.begin(), rest.end(), [&](const Spoke& s) { return s.end != first.end; });
      const auto edge = rest.first(static_cast<std::size_t>(end - rest.begin()));
      if (edge.size() > 2) {
        forward_.clear();
        backward_.clear();
        for (const Spoke& spoke : edge)
          (from(spoke.half_edge) < spoke.end ? forward_ : backward_).push_back(spoke.half_edge);
        match_crowded_edge();
      }
      for (const Spoke& spoke : edge.subspan(1))
        if (opposite_[first.half_edge] != spoke.half_edge) repeated_.push_back(spoke.half_edge);
      rest = rest.subspan(edge.size());
    }
  }

  void join(std::uint32_t a, std::uint32_t b) noexcept {
    opposite_[a] = b;
    opposite_[b] = a;
  }

  /// Both sides sorted by apex and matched one off: faces that exist in both orientations (two-sided sheets)
  /// then continue into their neighbours instead of closing upon their own twins, which saves gluing.
  void match_crowded_edge() {
    const auto by_apex = [this](std::uint32_t a, std::uint32_t b) {
      return std::pair(apex(a), a) < std::pair(apex(b), b);
    };
    std::sort(forward_.begin(), forward_.end(), by_apex);
    std::sort(backward_.begin(), backward_.end(), by_apex);
    const std::size_t pairs = std::min(forward_.size(), backward_.size());
    for (std::size_t i = 0; i < pairs; ++i) join(forward_[i], backward_[(i + 1) % backward_.size()]);
  }

  std::span<const std::uint32_t> triangles_;
  std::vector<std::uint32_t> heads_;  ///< first half-edge of every vertex' list
  std::vector<Edge> edges_;           ///< by the larger end
  std::vector<std::uint32_t> opposite_;
  std::vector<Spoke> spokes_;
  std::vector<std::uint32_t> forward_;
  std::vector<std::uint32_t> backward_;
  std::vector<std::uint32_t> repeated_;
  bool degenerate_ = false;
};

}  // namespace

HalfEdges match_half_edges(std::span<const std::uint32_t> triangles, std::uint32_t vertex_count) {
  return Matcher(triangles, vertex_count).match();
}

}  // namespace deltamesh
