// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The closed loops in which a surface cuts the edges of a cube: the borders of its faces there [GRD-6].
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "grid/cube/cube.h"

namespace deltamesh::grid {

/// Faces of the cube whose corners are in, out, in, out around it: the surface cuts all four edges and may
/// join them in two ways.
inline unsigned ambiguous_faces(Signs signs) noexcept {
  unsigned ambiguous = 0;
  for (unsigned f = 0; f < kFaces; ++f) {
    const auto& corner = kFaceCorners[f];
    const auto at = [&](unsigned i) { return signs >> corner[i] & 1; };
    if (at(0) == at(2) && at(1) == at(3) && at(0) != at(1)) ambiguous |= 1U << f;
  }
  return ambiguous;
}

/// One after the other; each has three edges or more.
class Loops {
 public:
  static constexpr unsigned kMost = 4;

  /// `around_outside`: a bit for each ambiguous face; where it is set the surface joins the two edges at each
  /// of its corners that are outside, else those at each that are inside.
  Loops(Signs signs, unsigned around_outside) noexcept {
    std::array<std::uint8_t, kEdges> next{};
    for (unsigned f = 0; f < kFaces; ++f) link(signs, f, (around_outside >> f & 1) != 0, next);
    unsigned done = 0;
    for (unsigned first = 0; first < kEdges; ++first) {
      const bool is_cut = (signs >> first_corner(first) & 1) != (signs >> last_corner(first) & 1);
      if (!is_cut || (done >> first & 1) != 0) continue;
      for (unsigned edge = first; (done >> edge & 1) == 0; edge = next[edge]) {
        done |= 1U << edge;
        edges_[ends_[count_]++] = static_cast<std::uint8_t>(edge);
      }
      ++count_;
      ends_[count_] = ends_[count_ - 1];
    }
  }

  unsigned count() const noexcept { return count_; }
  std::span<const std::uint8_t> operator[](unsigned i) const noexcept {
    const unsigned begin = i == 0 ? 0U : ends_[i - 1];
    return std::span(edges_).subspan(begin, ends_[i] - begin);
  }

 private:
  /// Going around face `f`: each edge at which one comes inside leads on to one at which one came outside.
  static void link(Signs signs, unsigned f, bool around_outside,
                   std::array<std::uint8_t, kEdges>& next) noexcept {
    const auto& corner = kFaceCorners[f];
    const auto outside = [&](unsigned i) { return (signs >> corner[i % 4] & 1) != 0; };
    const auto edge = [&](unsigned i) {
      return static_cast<std::uint8_t>(edge_between(corner[i % 4], corner[(i + 1) % 4]));
    };
    for (unsigned i = 0; i < 4; ++i) {
      if (outside(i) || !outside(i + 1)) continue;  // edge i leads outside
      unsigned back = i + 1;
      while (!outside(back) || outside(back + 1)) ++back;
      const bool is_ambiguous = !outside(i + 2) && outside(i + 3);
      if (is_ambiguous && !around_outside) back = i + 3;
      next[edge(back)] = edge(i);
    }
  }

  std::array<std::uint8_t, kEdges> edges_{};
  std::array<std::uint8_t, kMost + 1> ends_{};
  unsigned count_ = 0;
};

}  // namespace deltamesh::grid
