// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Tangents by rule: how the texture runs on the faces around a vertex, weighted by their angles at it, as
// exporters compute them (Mikkelsen 2008) [ATTR-40]. The same bits on every machine: + - * / and square
// roots, in the order written; shared by writer and reader.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "attributes/attribute_surface.h"
#include "attributes/normal_rule.h"
#include "base/large_vector.h"
#include "base/vec3.h"

namespace deltamesh {

/// What the faces around a vertex say.
struct RuledTangent {
  Vec3 normal{};          ///< unit, or 0 where nothing tells it
  Vec3 direction{};       ///< unit, orthogonal to the normal; 0 where no face has an area in the texture
  Vec3 by_area{};         ///< the same, of faces weighted by what noise does to them; unit
  double dispersion = 0;  ///< of the faces' directions, about radians
  double area = 0;        ///< sum of what the faces take in the texture
};

class TangentRule {
 public:
  /// `normals`: n x 3, must outlive it; `uvs`: n x 2. Either may be empty. O(n + m).
  TangentRule(const AttributeSurface& surface, std::span<const float> normals, std::span<const float> uvs);
  TangentRule(const TangentRule&) = delete;
  TangentRule& operator=(const TangentRule&) = delete;

  RuledTangent at(std::uint32_t vertex) const noexcept;

 private:
  std::vector<float> own_normals_;  ///< n x 3 where none are given
  std::span<const float> normals_;  ///< n x 3, or empty
  /// By vertex, over its faces, or empty: their directions by angle; the angles; their directions by area,
  /// the area.
  LargeVector<EightFloats> sums_;
};

}  // namespace deltamesh
