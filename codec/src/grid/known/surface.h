// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A mesh that both sides have, on the grid of another one [MAP-26, MAP-27].
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "deltamesh/known_mesh.h"
#include "format/predictive_parameters.h"
#include "grid/bricks.h"
#include "grid/cube/pattern.h"
#include "grid/known/vertex.h"

namespace deltamesh::grid {

/// What is known of an edge.
struct KnownEdge {
  std::uint32_t level = 0;
  std::int8_t cut = 0;  ///< its place, as in PlaceWindow
};

class KnownSurface {
 public:
  /// In which faces lie.
  struct Cube {
    Brick* brick;
    unsigned place;
  };

  /// Nothing where it takes too many bricks [MAP-27]. O(n + m).
  static std::optional<KnownSurface> make(const KnownMesh& mesh, const PredictiveParameters& parameters);

  /// In the order of their first faces.
  const std::vector<Cube>& cubes() const noexcept { return cubes_; }
  /// Precondition: it is one of cubes(). `brick`: of bricks().
  const Pattern& pattern(const Brick& brick, unsigned place) const noexcept {
    return patterns_.find(number_of(brick, place))->second;
  }
  /// With the states of nodes; `cubes`: 1 of those with faces, and `cut`: edges that have a vertex.
  const Bricks& bricks() const noexcept { return bricks_; }
  /// Precondition: `brick.cut` has it.
  const KnownEdge& edge(const Brick& brick, unsigned slot, unsigned axis) const noexcept {
    return edges_[bricks_.vertex(brick, slot, axis)];
  }

  /// For each vertex of another mesh on the grid the known one on its edge, or kNoKnownVertex. `positions`:
  /// n x 3. O(n).
  std::vector<std::uint32_t> vertices_at(std::span<const float> positions,
                                         const PredictiveParameters& parameters) const;

 private:
  struct Home;
  struct Face;

  bool add_vertices(const KnownMesh& mesh, const PredictiveParameters& parameters, std::vector<Home>& homes);
  void add_face(const Face& face);
  void add_bricks_around(const Cube& cube);
  Brick& brick_at(const Bricks::Place& at);
  void settle(const Cube& cube);
  static std::uint64_t number_of(const Brick& brick, unsigned place) noexcept {
    return std::uint64_t{brick.number} * kPlaces + place;
  }

  Bricks bricks_;
  Brick* last_ = nullptr;         ///< what brick_at() gave
  std::vector<KnownEdge> edges_;  ///< by vertex
  std::vector<Cube> cubes_;
  std::unordered_map<std::uint64_t, Pattern> patterns_;  ///< by number_of()
};

}  // namespace deltamesh::grid
