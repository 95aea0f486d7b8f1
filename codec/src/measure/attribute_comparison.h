// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Attributes of two meshes side by side: which stand for each other, and how far their values are apart.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "deltamesh/compare.h"
#include "deltamesh/mesh.h"

namespace deltamesh {

/// A vertex of A and one of B that stand for each other.
struct VertexPair {
  std::uint32_t a = 0;
  std::uint32_t b = 0;

  auto operator<=>(const VertexPair&) const = default;
};

/// Two meshes that have passed check_mesh() and must outlive it.
class AttributeComparer {
 public:
  /// Finds the pairs: the same name and kind; else the next of the same kind, but of generic ones.
  AttributeComparer(const MeshView& a, const MeshView& b);

  /// How different the values of two vertices are, beyond units: 0 to 1 for each pair of attributes.
  double difference(std::uint32_t a, std::uint32_t b) const;

  /// Whether both have colours of 3 components or more.
  bool has_colors() const noexcept { return first_colors() != nullptr; }

  /// Every attribute of A, then those only in B; errors over `vertices`. `color_difference`: for each vertex
  /// of B the largest CIEDE2000 of its pairs, of the first colours, is kept there; empty without colours.
  std::vector<AttributeComparison> compare(std::span<const VertexPair> vertices,
                                           std::span<float> color_difference) const;

 private:
  struct Pair {
    AttributeView a;
    AttributeView b;
    AttributeComparison result;  ///< without errors
  };
  const Pair* first_colors() const noexcept;

  std::vector<Pair> pairs_;
};

}  // namespace deltamesh
