// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What a decoder has to solve for a mesh coded in a given way.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/numbers/vec3.h"
#include "deltamesh/mesh.h"
#include "highpass/highpass.h"
#include "laplacian/operator/solved_part.h"

namespace deltamesh::bench {

struct ProblemSettings {
  double anchor_percent = 0.5;  ///< of the solved vertices
  int bits = 8;                 ///< of the delta quantiser
  double diffusion = 0;         ///< strength of the error diffusion, 0 to 1
};

/// In coding order.
struct Problem {
  Adjacency whole;                    ///< of all vertices
  std::vector<Vec3> whole_positions;  ///< of all vertices
  Box box;
  SolvedPart part;
  HighpassSettings settings;  ///< what an encoder is told

  // Over the solved vertices; positions relative to the middle of the box.
  std::vector<Vec3> positions;
  std::vector<std::uint32_t> anchors;
  std::vector<Vec3> deltas;   ///< quantised
  std::vector<Vec3> targets;  ///< of the anchors, quantised to 12 bits

  /// Of all vertices, those of the solved ones as `positions`.
  std::vector<Vec3> solved_of(std::span<const Vec3> all) const;
};

Problem make_problem(const MeshView& mesh, const ProblemSettings& settings);

double rms_difference(std::span<const Vec3> a, std::span<const Vec3> b);
double largest_difference(std::span<const Vec3> a, std::span<const Vec3> b);

}  // namespace deltamesh::bench
