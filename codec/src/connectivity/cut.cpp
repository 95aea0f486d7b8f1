// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "connectivity/cut.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace deltamesh {
namespace {

/// Finds the opposite half-edges, edge by edge.
class Matcher {
 public:
  Matcher(std::span<const std::uint32_t> triangles, std::uint32_t vertex_count)
      : triangles_(triangles), vertex_count_(vertex_count) {}

  std::vector<std::uint32_t> match() && {
    opposite_.assign(triangles_.size(), kNoIndex);
    const std::vector<std::uint32_t> offsets = sort_by_smaller_end();
    for (std::size_t v = 0; v < vertex_count_; ++v) {
      const std::span<std::uint64_t> row(edges_.data() + offsets[v], edges_.data() + offsets[v + 1]);
      std::sort(row.begin(), row.end());
      for (std::size_t begin = 0; begin < row.size();) {
        std::size_t end = begin + 1;
        while (end < row.size() && row[end] >> 32 == row[begin] >> 32) ++end;
        match_edge(row.subspan(begin, end - begin));
        begin = end;
      }
    }
    return std::move(opposite_);
  }

 private:
  std::uint32_t from(std::uint32_t h) const noexcept { return triangles_[h]; }
  std::uint32_t to(std::uint32_t h) const noexcept { return triangles_[next_in_face(h)]; }
  std::uint32_t apex(std::uint32_t h) const noexcept { return triangles_[previous_in_face(h)]; }
  std::uint32_t smaller_end(std::uint32_t h) const noexcept { return std::min(from(h), to(h)); }
  bool degenerate(std::uint32_t first) const noexcept {
    const std::uint32_t a = triangles_[first];
    const std::uint32_t b = triangles_[first + 1];
    const std::uint32_t c = triangles_[first + 2];
    return a == b || b == c || c == a;
  }

  /// Fills edges_ with (larger end, half-edge), grouped by the smaller end; returns the groups' offsets.
  std::vector<std::uint32_t> sort_by_smaller_end() {
    std::vector<std::uint32_t> offsets(vertex_count_ + 1, 0);
    for_each_half_edge([&](std::uint32_t h) { ++offsets[smaller_end(h) + 1]; });
    for (std::size_t v = 0; v < vertex_count_; ++v) offsets[v + 1] += offsets[v];
    edges_.resize(offsets.back());
    std::vector<std::uint32_t> cursor(offsets.begin(), offsets.end() - 1);
    for_each_half_edge([&](std::uint32_t h) {
      edges_[cursor[smaller_end(h)]++] = std::uint64_t{std::max(from(h), to(h))} << 32 | h;
    });
    return offsets;
  }

  template <class Visit>
  void for_each_half_edge(Visit&& visit) const {
    for (std::uint32_t first = 0; first < triangles_.size(); first += 3) {
      if (degenerate(first)) continue;
      for (std::uint32_t k = 0; k < 3; ++k) visit(first + k);
    }
  }

  void join(std::uint32_t a, std::uint32_t b) noexcept {
    opposite_[a] = b;
    opposite_[b] = a;
  }

  /// All half-edges between the same two vertices.
  void match_edge(std::span<const std::uint64_t> edge) {
    const auto half_edge = [](std::uint64_t entry) { return static_cast<std::uint32_t>(entry); };
    if (edge.size() == 2) {
      const std::uint32_t a = half_edge(edge[0]);
      const std::uint32_t b = half_edge(edge[1]);
      if (from(a) != from(b)) join(a, b);
    } else if (edge.size() > 2) {
      forward_.clear();
      backward_.clear();
      for (const std::uint64_t entry : edge) {
        const std::uint32_t h = half_edge(entry);
        (from(h) < to(h) ? forward_ : backward_).push_back(h);
      }
      match_crowded_edge();
    }
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
  std::size_t vertex_count_;
  std::vector<std::uint64_t> edges_;
  std::vector<std::uint32_t> opposite_;
  std::vector<std::uint32_t> forward_;
  std::vector<std::uint32_t> backward_;
};

/// Gives every corner of the fan around `corner` the manifold vertex `id`.
void label_fan(ManifoldCut& cut, std::uint32_t corner, std::uint32_t id) {
  std::uint32_t c = corner;
  do {
    cut.manifold_vertex[c] = id;
    const std::uint32_t across = cut.opposite[c];
    if (across == kNoIndex) break;
    c = next_in_face(across);
  } while (c != corner);
  if (cut.opposite[c] != kNoIndex) return;  // a closed fan
  for (c = corner;;) {                      // the other way, up to the fan's other end
    c = cut.opposite[previous_in_face(c)];
    if (c == kNoIndex) break;
    cut.manifold_vertex[c] = id;
  }
}

}  // namespace

ManifoldCut cut_to_manifold(std::span<const std::uint32_t> triangles, std::uint32_t vertex_count) {
  ManifoldCut cut;
  cut.opposite = Matcher(triangles, vertex_count).match();
  cut.manifold_vertex.assign(triangles.size(), kNoIndex);
  cut.vertex.reserve(vertex_count);
  for (std::uint32_t corner = 0; corner < triangles.size(); ++corner) {
    if (cut.manifold_vertex[corner] != kNoIndex) continue;
    label_fan(cut, corner, static_cast<std::uint32_t>(cut.vertex.size()));
    cut.vertex.push_back(triangles[corner]);
  }
  return cut;
}

}  // namespace deltamesh
