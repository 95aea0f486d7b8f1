// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A robot drives through generated rooms and maps them: blocks appear, move by noise and vanish.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include "deltamesh/mesh.h"
#include "deltamesh/result.h"
#include "field/building.h"
#include "field/marching_cubes.h"
#include "sequence.h"

namespace deltamesh {

inline constexpr std::uint64_t kMaxDriveVertices = 1'000'000;
inline constexpr std::uint32_t kDriveBlockVoxels = 16;
inline constexpr double kDriveStepSeconds = 0.2;

/// A truncated signed distance field that averages what a camera sees, and its surface block by block. A
/// person walks ahead of the robot. The same arguments give the same updates with every compiler.
class Drive {
 public:
  /// Rooms of about `vertices` vertices once all is seen. Errors: kInvalidArgument (out of 12 to
  /// kMaxDriveVertices). Throws std::bad_alloc only: takes 9 bytes a voxel.
  static Result<Drive> make(std::uint64_t vertices, std::uint64_t seed);

  /// The next fifth of a second: blocks that are new or differ from before, and those that are gone,
  /// ascending. Vertices that blocks share have the same bits in each.
  SequenceStep next();

  double voxel() const noexcept { return lattice_.voxel; }
  std::array<double, 3> origin() const noexcept {
    return {lattice_.base.x, lattice_.base.y, lattice_.base.z};
  }
  const std::map<SequenceBlockId, Mesh>& blocks() const noexcept { return blocks_; }

 private:
  Drive(scenes::Building building, double voxel, std::uint64_t seed);
  void plan_path();
  scenes::Point place_at(double metres) const;
  void observe(std::set<SequenceBlockId>& touched);
  bool observe_node(std::size_t node, const scenes::Point& p, const scenes::Item& person);
  Mesh mesh_of(const SequenceBlockId& id) const;
  std::size_t node_at(std::uint32_t i, std::uint32_t j, std::uint32_t k) const noexcept {
    return i * lattice_.layer_size() + std::size_t{j} * lattice_.nodes[2] + k;
  }

  scenes::Building building_;
  scenes::Lattice lattice_;
  std::uint64_t seed_;
  std::vector<scenes::Point> path_;   ///< closed
  std::vector<float> still_;          ///< of every node: what is there without the person
  std::vector<float> mapped_;         ///< what the map holds
  std::vector<std::uint8_t> weight_;  ///< how many observations that is the mean of
  std::uint32_t step_ = 0;
  std::map<SequenceBlockId, Mesh> blocks_;
};

}  // namespace deltamesh
