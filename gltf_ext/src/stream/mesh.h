// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Merges primitives into the mesh of one stream.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "stream/plan.h"

namespace deltamesh::gltf {

/// An attribute of the stream: primitives that have it in another shape have another attribute.
struct StreamAttribute {
  Semantic semantic;
  AccessorShape shape;  ///< its count does not matter
};

struct StreamMesh {
  Mesh mesh;                                ///< with face_groups where there is more than one group
  std::vector<StreamAttribute> attributes;  ///< what those of `mesh` are
  std::uint64_t unreferenced_vertices = 0;  ///< left out
  std::uint64_t degenerate_triangles = 0;   ///< left out, for they draw nothing
  std::uint64_t welded_vertices = 0;        ///< left out, for they equal another in all that they have
  double uv_scale = 1;                      ///< the largest of the primitives
  double smallest_diagonal = 1;             ///< see smallest_diagonal_share()
};

/// The number among `attributes` of what holds the values of `source`'s `attribute`: attributes of one kind
/// and bound that have equal values in a primitive share one. Size of `attributes` where there is none.
std::size_t stream_attribute(const std::vector<StreamAttribute>& attributes, const AccessorStore& store,
                             const PrimitiveSource& source, const SourceAttribute& attribute);

struct MergeOptions {
  bool keep_all = false;  ///< vertices that no triangle uses are kept
  bool weld = true;       ///< vertices that are equal in all attributes become one
  /// Triangles with two corners that are at one place, whatever morph targets and joints do, are left out; of
  /// a primitive that has no others all are kept.
  bool drop_degenerate = false;
  bool one_zero = true;  ///< coordinates of -0 become 0, or mirrored halves would not meet
};

/// The vertices stand in the order of `plan`, then of their accessors; the triangles in the order of the
/// groups. Positions become floats. Errors: kInvalidFile, kInvalidMesh (a position that is not finite),
/// kLimitExceeded; `where`: the primitive.
Result<StreamMesh> merge_primitives(const AccessorStore& store, const std::vector<PrimitiveSource>& sources,
                                    const StreamPlan& plan, const MergeOptions& options);

}  // namespace deltamesh::gltf
