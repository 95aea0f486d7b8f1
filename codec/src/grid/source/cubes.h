// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A mesh as cubes of a grid with faces in them. Encoder only.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <unordered_map>
#include <vector>

#include "grid/cube/pattern.h"
#include "grid/source/edge_vertices.h"
#include "grid/surface.h"

namespace deltamesh::grid {

/// The faces of a mesh, as far as they lie in cubes.
class SourceCubes {
 public:
  static constexpr std::uint32_t kNone = 0xffffffff;

  /// A face of a cube, beginning with its corner on the least edge.
  struct Face {
    Triangle corners{};
    std::uint8_t turn = 0;  ///< which corner of the mesh's face comes first
    std::uint32_t face = 0;
    bool operator<(const Face& other) const noexcept { return corners < other.corners; }
  };

  /// `triangles`: m x 3, of vertices with `cells` on a lattice of 2 `levels` steps to a voxel, none of them
  /// beyond `bricks`, which are fewer than 2^32 in all. O(n + m).
  SourceCubes(std::span<const std::uint32_t> triangles, std::span<const Cell> cells, std::uint32_t levels,
              const std::array<std::uint32_t, 3>& bricks);

  /// In the order of their bricks, and of their places there.
  const std::vector<CubePlace>& cubes() const noexcept { return cubes_; }
  /// The number of the cube there, or kNone.
  std::uint32_t find(const Bricks::Place& brick, std::uint32_t place) const noexcept;

  Signs signs(std::uint32_t cube) const noexcept { return signs_[cube]; }
  const Pattern& pattern(std::uint32_t cube) const noexcept { return patterns_[cube]; }
  /// In the order of the pattern's triangles.
  std::span<const Face> faces(std::uint32_t cube) const noexcept {
    return {faces_.data() + first_face_[cube], patterns_[cube].triangles().size()};
  }
  /// From the cube's lowest node, of the vertex inside it.
  std::uint32_t inner_offset(std::uint32_t cube, std::size_t axis) const noexcept;

  /// Faces that lie in no cube, ascending.
  const std::vector<std::uint32_t>& left_faces() const noexcept { return left_faces_; }

 private:
  /// Of one brick, by place. Its cubes are numbered one after the other.
  struct Part {
    static constexpr std::uint16_t kNoCube = 0xffff;

    std::uint32_t first_cube = 0;
    std::array<std::uint16_t, kPlaces> cubes{};  ///< their faces, then their numbers from the first one's
    std::array<std::int8_t, kPlaces> signs{};    ///< of nodes: above 0 outside, below 0 inside

    std::uint32_t cube(std::uint32_t place) const noexcept {
      return cubes[place] == kNoCube ? kNone : first_cube + cubes[place];
    }
  };
  /// A cube by the number of its part and its place.
  struct Address {
    std::uint32_t part = kNone;
    std::uint32_t place = 0;
  };

  Address address_of(const Node& node);
  std::array<std::int8_t*, kCorners> signs_around(std::uint32_t cube);
  void find_cubes(const EdgeVertices& vertices);
  void count_face(const Address& home) noexcept;
  void place_faces(const EdgeVertices& vertices, std::span<const Address> homes);
  void vote(std::uint32_t cube);
  void settle_signs(std::uint32_t cube);

  std::span<const std::uint32_t> triangles_;
  std::span<const Cell> cells_;
  std::int32_t voxel_;
  std::array<std::uint32_t, 3> bricks_;
  std::vector<std::unique_ptr<Part>> parts_;
  std::unordered_map<std::uint32_t, std::uint32_t> part_numbers_;  ///< by the brick's number in the grid
  std::uint32_t last_brick_ = kNone;                               ///< that was looked up, and its part
  std::uint32_t last_part_ = kNone;
  std::vector<CubePlace> cubes_;
  std::vector<Signs> signs_;
  std::vector<Pattern> patterns_;
  std::vector<std::uint32_t> first_face_;
  std::vector<Face> faces_;
  std::vector<std::uint32_t> left_faces_;
};

}  // namespace deltamesh::grid
