// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The encoder's side of the transform: a picture of one mesh, at any step.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "attributes/haar/levels/levels.h"
#include "attributes/haar/picture.h"
#include "attributes/values.h"
#include "base/memory/large_vector.h"
#include "deltamesh/mesh.h"

namespace deltamesh {

struct HaarModels;

/// By level of the transform and node: the means of its vertices' values.
using HaarMeans = std::vector<LargeVector<HaarMean>>;

class HaarWriter {
 public:
  /// `levels`: which make_haar_levels() made; must outlive the writer. O(n).
  HaarWriter(HaarPicture picture, std::span<const HaarLevel> levels);

  /// `step`: of a coefficient, 64ths of a level, 1 to kMostHaarStep; the rms of all errors is about 0.3 of
  /// it. `type`: of the values. `start`: null for fresh models; those of alpha always are. O(n).
  CodedValues<std::byte> code(std::uint32_t step, ComponentType type,
                              const HaarModels* start = nullptr) const;

 private:
  std::span<const HaarLevel> levels_;
  HaarFields fields_;
  unsigned components_;
  HaarMeans values_;
  HaarMeans alpha_;  ///< empty where it is constant, or there is none
};

}  // namespace deltamesh
