// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What the faces around a vertex say of it when all vertices before it are known [POSN-3].
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace deltamesh {

/// The faces at every vertex, in face order, each as its two other corners.
class FaceStars {
 public:
  struct Wing {
    std::uint32_t next;      ///< the corner after the vertex
    std::uint32_t previous;  ///< the corner before it
  };

  /// `triangles`: m x 3 indices below `vertex_count`. O(n + m).
  FaceStars(std::span<const std::uint32_t> triangles, std::uint32_t vertex_count);
  /// `offsets`: n + 1, where the wings of each vertex begin.
  FaceStars(std::vector<Wing> wings, std::vector<std::uint32_t> offsets) noexcept
      : offsets_(std::move(offsets)), wings_(std::move(wings)) {}

  std::span<const Wing> of(std::uint32_t vertex) const noexcept {
    return {wings_.data() + offsets_[vertex], wings_.data() + offsets_[vertex + 1]};
  }
  std::uint32_t vertex_count() const noexcept { return static_cast<std::uint32_t>(offsets_.size() - 1); }

 private:
  std::vector<std::uint32_t> offsets_;
  std::vector<Wing> wings_;
};

/// Two faces across the edge a - b: one has the vertex to come, the other `opposite`.
struct Parallelogram {
  std::uint32_t a;
  std::uint32_t b;
  std::uint32_t opposite;
};

struct Surroundings {
  static constexpr unsigned kMostParallelograms = 8;
  static constexpr unsigned kMostNeighbors = 16;
  static constexpr unsigned kMostEdges = 16;      ///< that are looked across
  static constexpr unsigned kMostOpposites = 32;  ///< faces that are looked at there

  std::array<FaceStars::Wing, kMostEdges> known;  ///< faces whose two other corners are before the vertex
  unsigned known_count = 0;
  std::array<Parallelogram, kMostParallelograms> parallelograms;
  unsigned parallelogram_count = 0;
  std::array<std::uint32_t, kMostNeighbors> neighbors;  ///< vertices before this one, each once
  unsigned neighbor_count = 0;
  std::uint32_t faces = 0;  ///< at the vertex, whatever their other corners
};

/// Looks at the faces of `vertex` in their order. O(faces at it).
Surroundings look_around(const FaceStars& stars, std::uint32_t vertex) noexcept;

}  // namespace deltamesh
