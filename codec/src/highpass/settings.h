// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Everything that decides on the bytes of a highpass stream: what a search chooses and the coder does.
#pragma once

#include <cstdint>
#include <vector>

namespace deltamesh {

struct HighpassSettings {
  double step = 1;                            ///< of delta coordinates, model units, finite, above 0
  double rate_weight = 0;                     ///< 0 or more; more makes symbols cheaper and errors larger
  bool centroids = false;                     ///< reconstruct at the centroids of bins: a lower VDE
  double diffusion = 0;                       ///< strength of error diffusion, 0 to 1
  std::uint32_t anchors = 0;                  ///< the first so many of the anchor sequence
  std::vector<std::uint32_t> more_anchors{};  ///< vertices that are anchors besides
  bool mends = false;                         ///< more anchors may follow, at the largest errors
  int anchor_bits = 12;                       ///< 4 to 24

  bool operator==(const HighpassSettings& other) const = default;
  bool has_same_deltas(const HighpassSettings& other) const noexcept {
    return step == other.step && rate_weight == other.rate_weight && diffusion == other.diffusion &&
           centroids == other.centroids;
  }
};

}  // namespace deltamesh
