// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// How soon a receiver that has nothing sees a whole map, and has it as it asks.
#pragma once

#include <cstdint>

#include "map/updates.h"

namespace deltamesh::bench {

struct FirstSight {
  double all_seen = 0;           ///< seconds until all of the map is shown, however coarse
  double all_there = 0;          ///< seconds until all is as asked for
  std::uint64_t bytes = 0;       ///< to the receiver until then
  std::uint64_t copy_bytes = 0;  ///< of these, messages with coarser copies
  double update = 0;             ///< processor time of the update with all blocks, milliseconds
  double longest_call = 0;       ///< of messages_for(), processor time, milliseconds
};

/// `map`: one step with all blocks. `rate`: bytes per second of the link and of the view, in simulated time:
/// that of processors is not counted in. Exits where an end fails.
FirstSight measure_first_sight(const MapUpdates& map, std::uint8_t copy_level, double rate);

}  // namespace deltamesh::bench
