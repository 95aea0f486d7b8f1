// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A long mission: memory and processor time of both ends over many updates.
#pragma once

#include <array>
#include <cstdint>
#include <functional>

#include "map/updates.h"

namespace deltamesh::bench {

struct MissionSettings {
  std::uint32_t updates = 10'000;
  std::uint32_t viewers = 10;  ///< each with a view of its own
  double loss = 0.02;          ///< of messages, both ways
  std::uint32_t seed = 1;
};

/// Of a tenth of the updates: means.
struct MissionTenth {
  double megabytes = 0;     ///< on the heap, of the sender and all receivers
  double milliseconds = 0;  ///< processor time of all of them, an update
  double kilobytes = 0;     ///< to all receivers, an update
  double encoded = 0;  ///< parts and patches, an update: work that no other program on the machine changes
};

struct MissionResult {
  std::array<MissionTenth, 10> tenths{};
  bool has_all = false;  ///< each receiver's map is the sender's in the end
};

/// `updates` again and again, so that after the first time the map has all its blocks. `tell`: called after
/// each tenth. Exits where an end fails.
MissionResult run_mission(const MapUpdates& updates, const MissionSettings& settings,
                          const std::function<void(const MissionTenth&)>& tell);

}  // namespace deltamesh::bench
