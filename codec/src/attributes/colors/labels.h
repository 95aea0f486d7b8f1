// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Tells colours that stand for something, such as ids or classes, from those of photographs.
#pragma once

#include <cstdint>
#include <span>

#include "topology/adjacency.h"

namespace deltamesh {

struct ColorEdges {
  std::uint64_t equal = 0;      ///< edges between equal colours
  std::uint64_t near = 0;       ///< that differ by 8 of 255 at most in each component
  std::uint64_t different = 0;  ///< all that are not equal
};

/// `colors`: n x `components` levels of the vertices of `graph`. O(n + edges).
ColorEdges count_color_edges(std::span<const std::uint8_t> colors, unsigned components,
                             const Adjacency& graph);

/// Whether these are the colours of labels, which an error would turn into other labels: more than 55 % of
/// the edges join equal ones, or less than 5 % of the others join near ones. Without edges they may be
/// anything, labels too. Photographs have 3 to 46 % and 11 to 95 %; labels with noise or blended at their
/// borders 62 % and more, or less than 5 %. For whole maps: parts of 300 vertices are too small to tell.
bool are_labels(const ColorEdges& edges) noexcept;

}  // namespace deltamesh
