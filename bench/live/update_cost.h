// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What an update of one block takes in a map of many.
#pragma once

#include <cstddef>
#include <cstdint>

#include "map/updates.h"

namespace deltamesh::bench {

/// Processor time, milliseconds.
struct UpdateCost {
  std::size_t vertices = 0;
  std::size_t blocks = 0;
  std::size_t parts = 0;
  double first = 0;  ///< of an update with all blocks
  double median =
      0;  ///< of updates with one block whose vertices have all moved, over blocks all over the map
  double largest = 0;  ///< of these
};

/// `map`: one step with all blocks. Exits where the sender fails.
UpdateCost measure_update_cost(const MapUpdates& map, std::uint8_t copy_level);

}  // namespace deltamesh::bench
