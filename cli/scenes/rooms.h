// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What the map of some rooms and the drive through them have in common.
#pragma once

#include <cstdint>

#include "field/building.h"
#include "field/marching_cubes.h"

namespace deltamesh::scenes {

/// How many rooms, and which voxel edge in metres, a map of about `vertices` vertices takes.
struct RoomsPlan {
  std::uint32_t rooms = 1;
  double voxel = 0;
};
RoomsPlan plan_rooms(std::uint64_t vertices);

/// Tenths of a millimetre, as people choose them.
double round_voxel(double voxel);

/// With things that hang in the air, about two voxels in radius.
Building make_building(const RoomsPlan& plan, std::uint64_t seed);

/// A lattice around the building, with at least two voxels to spare on every side.
Lattice lattice_around(const Building& building, double voxel);

}  // namespace deltamesh::scenes
