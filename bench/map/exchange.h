// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A sender and a receiver next to each other, through all updates of a map.
#pragma once

#include <cstdint>

#include "deltamesh/attribute_quality.h"
#include "map/updates.h"

namespace deltamesh::bench {

/// What all sides are asked for.
struct Bounds {
  double max_error = 0;  ///< model units
  int color_error = 4;   ///< of 255
  double color_rms = 0;  ///< of 255, instead; 0: none. Draco keeps color_error
  int effort = 0;
};

/// What a sequence took.
AttributeQuality quality_of(const Bounds& bounds);

struct Sums {
  std::uint64_t bytes = 0;
  std::uint64_t sent = 0;
  std::uint64_t kept = 0;
  double encode = 0;  ///< seconds of processor time, as all times here
  double decode = 0;
  double join = 0;            ///< of the parts that an update changed, to one mesh
  double largest_update = 0;  ///< encode, decode and join
  double largest_error = 0;   ///< of the receiver's map against the source, model units; where measured
};

struct ExchangeSettings {
  std::uint32_t most_triangles = 24576;  ///< of a part of several blocks; about 12 KB at the usual errors
  bool keeps_good_enough = true;         ///< what the receiver has, where that is within bounds
  bool measures = false;                 ///< the receiver's map after every update
};

/// Exits where sender or receiver fails.
Sums run_map(const MapUpdates& updates, const Bounds& bounds, const ExchangeSettings& settings);

}  // namespace deltamesh::bench
