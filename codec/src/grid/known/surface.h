// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A mesh that both sides have, on the grid of another one [MAP-26, MAP-27].
#pragma once

#include <array>
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
  bool stays = false;   ///< a face that stays has the vertex
};

class KnownSurface {
 public:
  static constexpr unsigned kGoes = 1;   ///< of a cube: a face in it does not stay
  static constexpr unsigned kStays = 2;  ///< of a cube: a face in it stays

  struct Cube {
    Brick* brick;
    unsigned place;

    unsigned kind() const noexcept { return brick->cubes[place]; }
  };

  /// Nothing where it takes too many bricks [MAP-27]. O(n + m).
  static std::optional<KnownSurface> make(const KnownMesh& mesh, const PredictiveParameters& parameters);

  /// In the order of their first faces.
  const std::vector<Cube>& cubes() const noexcept { return cubes_; }
  /// Of the faces that do not stay. Precondition: there are such. `brick`: of bricks().
  const Pattern& gone(const Brick& brick, unsigned place) const noexcept {
    return gone_.find(number_of(brick, place))->second;
  }
  /// With the states of nodes, the kinds of cubes and, as `cut`, edges that have a vertex.
  const Bricks& bricks() const noexcept { return bricks_; }
  /// Precondition: `brick.cut` has it.
  const KnownEdge& edge(const Brick& brick, unsigned slot, unsigned axis) const noexcept {
    return edges_[bricks_.vertex(brick, slot, axis)];
  }

  /// At each vertex of another mesh on the grid. `positions`: n x 3. O(n).
  std::vector<KnownVertex> vertices_at(std::span<const float> positions,
                                       const PredictiveParameters& parameters) const;

 private:
  struct Home;
  struct Face;

  bool add_vertices(const KnownMesh& mesh, const PredictiveParameters& parameters, std::vector<Home>& homes);
  void add_face(const Face& face, bool stays);
  Brick& brick_at(const Bricks::Place& at);
  void settle(const Cube& cube);
  static std::uint64_t number_of(const Brick& brick, unsigned place) noexcept {
    return std::uint64_t{brick.number} * kPlaces + place;
  }

  Bricks bricks_;
  Brick* last_ = nullptr;         ///< what brick_at() gave
  std::vector<KnownEdge> edges_;  ///< by vertex
  std::vector<Cube> cubes_;
  std::unordered_map<std::uint64_t, Pattern> gone_;
};

}  // namespace deltamesh::grid
