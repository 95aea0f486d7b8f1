// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Matches the faces of two meshes, whatever the order of vertices and faces: matched faces are nearly at the
// same place and have matched neighbours.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "measure/face_graph.h"

namespace deltamesh {

inline constexpr std::uint32_t kNoFace = 0xffffffff;

struct FaceMatch {
  std::uint32_t face = kNoFace;  ///< of A
  std::uint8_t rotation = 0;     ///< corner k of B's face is corner (k + rotation) % 3 of A's
};

/// How different vertex `a` of A and `b` of B are beside their places, 0 or above: tells faces apart whose
/// places are the same.
using VertexDifference = std::function<double(std::uint32_t a, std::uint32_t b)>;

/// A match for every face of `b`; no face of `a` is matched twice, and both run around the same way.
/// Starts at the faces of `b` with the largest area, each with the nearest face of `a`, and goes on from
/// face to face across edges, the best fitting pair first, so that errors larger than an edge do no harm
/// where both meshes have the same faces. `difference` may be empty. O((n + m) log(n + m)).
std::vector<FaceMatch> match_faces(const FaceGraph& a, const FaceGraph& b,
                                   const VertexDifference& difference);

}  // namespace deltamesh
