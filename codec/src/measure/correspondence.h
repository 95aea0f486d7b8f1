// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Matches the vertices of two meshes.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "measure/attribute_comparison.h"

namespace deltamesh {

inline constexpr std::uint32_t kUnmatched = 0xffffffff;

/// Vertices of A and B that stand for each other.
struct Correspondence {
  bool whole = false;  ///< all faces of both
  bool reordered = false;
  /// A vertex of A at the place of each of B's; only where whole. kUnmatched of those that no face uses, if
  /// not all of them are A's.
  std::vector<std::uint32_t> order;
  std::vector<VertexPair> pairs;  ///< at the corners of matched faces, each once
  std::uint64_t faces = 0;        ///< matched ones
};

/// By `order`, a vertex of A for every vertex of B; where it is empty by the vertices' numbers if these fit
/// and faces are not much nearer otherwise, else by the places of faces, `attributes` telling apart what is
/// at one place. Both meshes have passed check_mesh(). O((n + m) log(n + m)).
Correspondence correspondence_of(const MeshView& a, const MeshView& b, std::span<const std::uint32_t> order,
                                 const AttributeComparer& attributes);

}  // namespace deltamesh
