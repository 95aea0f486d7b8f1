// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Where a map is: a loop closure moves a submap by its pose alone.
#pragma once

#include <array>
#include <cstdint>

namespace deltamesh {

/// The map's frame in a frame of the caller's, at a time: p becomes R p + translation, for positions p with
/// the map's origin added, in model units. R is that of the unit quaternion w + xi + yj + zk.
struct MapPose {
  std::uint64_t stamp = 0;                     ///< nanoseconds of any clock
  std::array<double, 4> rotation{1, 0, 0, 0};  ///< w, x, y, z; of length 1 within 1e-6
  std::array<double, 3> translation{};         ///< finite

  bool operator==(const MapPose&) const = default;
};

}  // namespace deltamesh
