// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Tangents by rule: how the texture runs on the faces around a vertex, weighted by their angles at it, as
// exporters compute them (Mikkelsen 2008) [ATTR-40]. The same bits on every machine: + - * / and square
// roots, in the order written; shared by writer and reader.
#pragma once

#include <cstdint>
#include <span>

#include "attributes/normals/rule.h"
#include "attributes/surface.h"
#include "base/memory/large_vector.h"
#include "base/simd/four_floats.h"

namespace deltamesh {

/// A vertex' normal and tangent direction by the faces around it. Fourth lanes are not used.
struct RuledTangent {
  FourFloats normal{};     ///< 0 where nothing tells it
  FourFloats direction{};  ///< orthogonal to a normal of length 1, of any length
  float dispersion = 0;    ///< of the faces' directions, about radians
  float area = 0;          ///< sum of what the faces take in the texture
};

class TangentRule {
 public:
  /// `normals`: n x 3, must outlive it; `uvs`: n x 2. Either may be empty. O(n + m).
  TangentRule(const AttributeSurface& surface, std::span<const float> normals, std::span<const float> uvs);
  TangentRule(const TangentRule&) = delete;
  TangentRule& operator=(const TangentRule&) = delete;

  RuledTangent at(std::uint32_t vertex) const noexcept;

 private:
  /// Sums over the faces at a vertex.
  struct Sum {
    FourFloats direction{};  ///< weighted by angle; then the angles
    float area = 0;
  };

  std::span<const float> normals_;    ///< n x 3, or empty
  LargeVector<RuleSum> own_normals_;  ///< where there are none; n, or empty
  LargeVector<Sum> sums_;             ///< n, or empty
};

}  // namespace deltamesh
