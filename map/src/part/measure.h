// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Measures the errors of a receiver's part against its source.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/numbers/vec3.h"
#include "deltamesh/mesh.h"
#include "deltamesh/stream_info.h"
#include "topology/adjacency.h"
#include "topology/weld.h"

namespace deltamesh {

/// Prepares comparisons with one source.
class PartMeasure {
 public:
  /// `source`: every vertex is used by a face; must outlive this.
  explicit PartMeasure(const Mesh& source);

  /// `positions`: of a decoded mesh, n x 3; `order`: the source's vertex for each of them.
  Quality compare(std::span<const float> positions, std::span<const std::uint32_t> order) const;

  std::uint64_t geometric_count() const noexcept { return weld_.representative.size(); }
  double diagonal() const noexcept { return diagonal_; }  ///< of the source's bounding box

 private:
  Weld weld_;
  std::vector<Vec3> original_;
  Adjacency graph_;
  double diagonal_ = 0;
};

}  // namespace deltamesh
