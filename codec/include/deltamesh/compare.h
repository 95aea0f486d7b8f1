// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// How far two meshes are apart.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "deltamesh/mesh.h"
#include "deltamesh/result.h"
#include "deltamesh/stream_info.h"

namespace deltamesh {

/// Distances between two meshes, model units.
struct Comparison {
  bool corresponding =
      false;        ///< vertices and faces correspond, so that `quality` and the angles are per vertex
  Quality quality;  ///< VDE, LFE and max vertex error; only where corresponding
  std::uint64_t measured_vertices = 0;  ///< position-welded vertices that a face uses
  double surface_rms =
      0;  ///< symmetric point-to-surface distance, root mean square over the vertices of both meshes
  double surface_max = 0;        ///< the same, largest
  double normal_angle_mean = 0;  ///< degrees, between area-weighted vertex normals
  double normal_angle_p95 = 0;   ///< degrees, 95th percentile
  double diagonal = 0;           ///< of A's bounding box
  std::vector<float>
      signed_error;  ///< per vertex of B: displacement from A along A's normal, outward positive
};

/// Compares `b` (the approximation) with `a` (the original). `order`: the vertex of `a` for every vertex of
/// `b` (empty: same index). Vertices correspond when the counts fit and every triangle of `b` is a triangle
/// of `a` (same orientation, any rotation, any order) under `order`; otherwise distances to the surface are
/// used. Errors: kInvalidMesh, kInvalidArgument (`order` with an index out of range or of a wrong length),
/// kOutOfMemory.
Result<Comparison> compare(const MeshView& a, const MeshView& b,
                           std::span<const std::uint32_t> order = {}) noexcept;

}  // namespace deltamesh
