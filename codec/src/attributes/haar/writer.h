// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The encoder's side of the transform: colours of one mesh, at any step.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "attributes/haar/fields.h"
#include "attributes/haar/levels.h"
#include "attributes/values.h"
#include "base/memory/large_vector.h"
#include "deltamesh/mesh.h"

namespace deltamesh {

/// Levels of 8 bits of the vertices.
struct HaarPicture {
  std::vector<std::uint8_t> levels;  ///< n x components
  unsigned components = kHaarAxes;   ///< 3 or 4
};

/// By level of the transform and node: the means of its vertices' values.
using HaarMeans = std::vector<LargeVector<std::array<float, kHaarAxes>>>;

class HaarWriter {
 public:
  /// `levels`: which make_haar_levels() made; must outlive the writer. O(n).
  HaarWriter(const HaarPicture& picture, std::span<const HaarLevel> levels);

  /// `step`: of a coefficient, 64ths of a level, 1 to kMostHaarStep; the rms of all errors is about 0.3 of
  /// it. `type`: of the values. O(n).
  CodedValues<std::byte> code(std::uint32_t step, ComponentType type) const;

 private:
  std::span<const HaarLevel> levels_;
  HaarFields fields_;
  HaarMeans colors_;
  HaarMeans alpha_;  ///< empty where it is constant, or there is none
};

}  // namespace deltamesh
