// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The first and the last face of every vertex whose other corners are known before it, in two interleaved
// sequences [POSN-12].
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/memory/large_vector.h"
#include "base/simd/four_ints.h"
#include "positions/grid/rotated_face.h"
#include "positions/surroundings.h"

namespace deltamesh {

class VoxelFaces {
 public:
  /// Corners a and b of the first face, then of the last one, which may be the same; none() where there is no
  /// face.
  struct alignas(16) Star : std::array<std::uint32_t, 4> {};

  /// `order`: the vertices in coding order, by which they are numbered here; empty where they are already.
  /// O(n + m); memory for the vertices up to the last one with a face.
  /// `two_sequences`: or a single one [POSN-12].
  explicit VoxelFaces(const FaceList& list, std::span<const std::uint32_t> order = {},
                      bool two_sequences = true);

  std::uint32_t vertex_count() const noexcept { return vertex_count_; }
  /// The first vertex of the second sequence, which has as many as the first or one less, or none.
  std::uint32_t second_sequence() const noexcept { return second_sequence_; }
  /// Number of steps [POSN-12]. In each a vertex of either sequence is coded; those of lower steps are known.
  std::uint32_t steps() const noexcept { return second_sequence_; }
  /// Stands for "no vertex".
  std::uint32_t none() const noexcept { return vertex_count(); }

  const Star& star(std::uint32_t vertex) const noexcept { return stars_[std::min(vertex, with_faces_)]; }
  /// The vertex across the edge of `a` and `b`: of the later one of these, the first face in its star that
  /// also has the earlier one gives the other corner. none() if there is no such face, or if `a` or `b` is
  /// none().
  std::uint32_t across(std::uint32_t a, std::uint32_t b) const noexcept;
  /// The known faces in the form of Surroundings, for expect_place() [POSN-4].
  Surroundings around(std::uint32_t vertex) const noexcept;

 private:
  std::uint32_t step_of(std::uint32_t vertex) const noexcept {
    return std::min(vertex, vertex - second_sequence_);
  }
  void add_all(std::span<const std::uint32_t> triangles);
  void add(const RotatedFace& face) noexcept;
  /// Adds a face with corners in both sequences, at most one of which has a later step than the others.
  void add_across_sequences(const std::array<std::uint32_t, 3>& corners) noexcept;

  std::uint32_t with_faces_;  ///< no vertex from there on has a face
  LargeVector<Star> stars_;   ///< of those below, and one without faces
  std::uint32_t vertex_count_;
  std::uint32_t second_sequence_;
};

[[gnu::always_inline]] inline std::uint32_t VoxelFaces::across(std::uint32_t a,
                                                               std::uint32_t b) const noexcept {
  // Without branches, which would often go wrong.
  const std::uint32_t earlier = choose(step_of(b) > step_of(a), a, b);
  const Star& star = this->star(a ^ b ^ earlier);
  const unsigned found = set_lanes(four_ints(star) == static_cast<std::int32_t>(earlier));
  // Lanes 0 and 1 are a face, 2 and 3 are one.
  const std::uint32_t other = star[static_cast<std::size_t>(std::countr_zero(found | 8)) ^ 1];
  return choose(found != 0, other, none());
}

}  // namespace deltamesh
