// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// How far two meshes are apart.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "deltamesh/mesh.h"
#include "deltamesh/result.h"
#include "deltamesh/stream_info.h"

namespace deltamesh {

/// How an attribute of A was matched with one of B.
enum class AttributeMatch : std::uint8_t {
  kCompared,    ///< both meshes have it
  kMissingInB,  ///< B has none of this name and kind, nor another of the kind
  kOnlyInB,
  kOtherType,  ///< B's has other components, or only one is normalized (colours apart)
};

/// An attribute of both meshes. Errors in degrees (normals, tangents; 180 where a tangent's sign differs),
/// distance (texture coordinates), 255ths of the range (colours, the worst component), or the attribute's own
/// unit (others, the worst component; integer weights as parts of 1); 0 where nothing was measured.
struct AttributeComparison {
  std::string name;  ///< in A, or in B where only B has it
  AttributeKind kind = AttributeKind::kGeneric;
  AttributeMatch match = AttributeMatch::kCompared;
  std::uint64_t measured = 0;  ///< pairs of a vertex of A and a vertex of B
  double max_error = 0;        ///< infinity where a difference is not a number
  double mean = 0;
  double rms = 0;
  double color_rms = 0;  ///< colours: over all values of red, green and blue, 255ths
  /// Colours: mean CIEDE2000 of what a screen shows; 1 is about what an eye can tell.
  double color_difference = 0;
};

/// Distances between two meshes, model units.
struct Comparison {
  bool corresponding =
      false;               ///< vertices and faces correspond, so that `quality` and the angles are per vertex
  bool reordered = false;  ///< they do in another order, which compare() found
  std::uint64_t matched_faces = 0;      ///< faces of B that are faces of A, with the same corners
  std::uint64_t unmatched_faces_a = 0;  ///< faces of A that B does not have
  std::uint64_t unmatched_faces_b = 0;
  Quality quality;                      ///< VDE, LFE and max vertex error; only where corresponding
  std::uint64_t measured_vertices = 0;  ///< position-welded vertices that a face uses
  /// Symmetric point-to-surface distance, root mean square over the vertices of both meshes; only where not
  /// corresponding.
  double surface_rms = 0;
  double surface_max = 0;        ///< the same, largest
  double normal_angle_mean = 0;  ///< degrees, between area-weighted vertex normals
  double normal_angle_p95 = 0;   ///< degrees, 95th percentile
  double diagonal = 0;           ///< of A's bounding box
  /// A's attributes in its order, then those only in B. Errors are measured at the corners of matched faces.
  std::vector<AttributeComparison> attributes;
  std::vector<float>
      signed_error;  ///< per vertex of B: displacement from A along A's normal, outward positive
  /// Per vertex of B: CIEDE2000 of the first colours that both have, at its worst corner; 0 where nothing was
  /// measured. Empty without such colours.
  std::vector<float> color_difference;
};

/// Added to the positions of two meshes before they are compared, as Imported::roundings: 3 for each vertex,
/// or empty.
struct Roundings {
  std::span<const float> a{};
  std::span<const float> b{};
};

/// Compares `b` (the approximation) with `a` (the original). `order`: the vertex of `a` for every vertex of
/// `b`; vertices correspond when the counts fit and every triangle of `b` is a triangle of `a` (same
/// orientation, any rotation, any order) under it. Empty: the same index; where that does not correspond,
/// or other places are much nearer, faces are matched by place and neighbours, copies of a vertex told apart
/// by their faces and attributes, and the meshes correspond where this finds all faces of both. Otherwise
/// distances to the surface are used. Attributes stand for each other by name and kind, else by kind in their
/// order. Cost O(n log n). Errors: kInvalidMesh, kNotFinite, kLimitExceeded (what a stream cannot hold, such
/// as more than 1024 attributes), kInvalidArgument (`order` with an index out of range or of a wrong length;
/// `roundings` of a wrong length; one mesh without faces, the other with some), kOutOfMemory.
Result<Comparison> compare(const MeshView& a, const MeshView& b, std::span<const std::uint32_t> order = {},
                           const Roundings& roundings = {}) noexcept;

}  // namespace deltamesh
