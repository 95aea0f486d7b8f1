// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Tells colours of photographs from those of labels.
#pragma once

#include <cstdint>
#include <vector>

#include "deltamesh/attribute_quality.h"
#include "deltamesh/mesh.h"
#include "deltamesh/result.h"

namespace deltamesh {

/// Edges of faces by how far the colours of their ends differ; an edge of two faces counts twice.
struct ColorEdges {
  std::uint64_t equal = 0;
  std::uint64_t near = 0;  ///< by 8 of 255 at most in each component
  std::uint64_t far = 0;   ///< by more than 32 of 255 in one
  std::uint64_t all = 0;

  ColorEdges& operator+=(const ColorEdges& other) noexcept;
};

/// What the colours of a mesh are, or of all meshes that belong together, such as the tiles of a map: those
/// of photographs, of which a small mean error is hardly seen, or labels (ids, classes), which any error
/// would turn into other labels. Photographs have more near edges than half of the equal ones and three
/// quarters of the far ones together: 1.25 times as many and more, where labels, noisy or blended at their
/// borders, have 0.67 times as many at most. Fewer than 1000 faces are too few to tell, and not taken for
/// photographs.
class ColorContent {
 public:
  /// `mesh`: with the same attributes as those before. O(n + m). Errors: kInvalidMesh, kOutOfMemory.
  Result<void> add(const MeshView& mesh) noexcept;

  /// Whether there are colours, and all of them are those of photographs.
  bool is_photographic() const noexcept;
  /// Whether any colours are labels; false where that is not known.
  bool has_labels() const noexcept;
  /// Whether there are colours of 1000 faces.
  bool is_known() const noexcept { return is_photographic() || has_labels(); }

  /// `quality`, with what it does not say of colours: a largest error of 0, or kPhotographicRms.
  AttributeQuality complete(AttributeQuality quality) const;

 private:
  std::vector<ColorEdges> edges_;  ///< of each attribute that is colours
};

}  // namespace deltamesh
