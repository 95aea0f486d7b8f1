// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What a receiver shows beside what its sender has: how old, and how far off.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "deltamesh/map/receiver.h"
#include "deltamesh/map/sender.h"

namespace deltamesh::bench {

/// Ages of what is shown: since when there has been something newer for the receiver.
class ShownAges {
 public:
  struct Age {
    std::size_t behind = 0;  ///< parts of which something else is shown than was sent last
    double oldest = 0;       ///< of these, seconds
  };

  /// Of the receiver with the number 1. To be called often: what was replaced between calls is not seen.
  Age at(double now, const MapSender& sender, const MapReceiver& receiver);

 private:
  std::map<PartKey, std::vector<std::pair<double, std::uint64_t>>> sent_;  ///< from what is shown on; 0: gone
};

/// How far off what is shown is: root mean square over all vertices of the sender's map of the distance to
/// the nearest vertex that is shown of the same part, model units.
class ShownError {
 public:
  /// `most`: where a vertex is farther off, or nothing is shown.
  explicit ShownError(double most) : most_(most) {}

  /// O(n^2) for the vertices of parts that have changed since the last call.
  double of(const MapSender& sender, const MapReceiver& receiver);

 private:
  struct Part {
    std::vector<float> source{};
    std::vector<float> shown{};
    double sum = 0;  ///< of squares
  };

  double most_;
  std::map<PartKey, Part> parts_{};
};

}  // namespace deltamesh::bench
