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
  std::uint64_t equal = 0;  ///< edges between equal colours
  std::uint64_t near = 0;   ///< that differ by 8 of 255 at most in each component
  std::uint64_t far = 0;    ///< that differ by more than 32 in one
};

/// `colors`: n x `components` levels of the vertices of `graph`. O(n + edges).
ColorEdges count_color_edges(std::span<const std::uint8_t> colors, unsigned components,
                             const Adjacency& graph);

/// Whether these are the colours of labels, which an error would turn into other labels: near edges are fewer
/// than half of the equal ones and three quarters of the far ones together. Photographs have 1.25 times as
/// many near ones as that and more; labels, noisy or blended at their borders, at most 0.67 times as many.
/// Without near edges they may be anything, labels too. For whole maps: parts are too small to tell.
bool are_labels(const ColorEdges& edges) noexcept;

}  // namespace deltamesh
