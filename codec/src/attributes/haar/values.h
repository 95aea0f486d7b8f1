// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Decoded records to colours.
#pragma once

#include <cstddef>
#include <vector>

#include "attributes/haar/surroundings.h"
#include "base/memory/large_vector.h"

namespace deltamesh {

/// n x 3 levels.
inline std::vector<std::byte> haar_colors(const LargeVector<HaarRecord>& records, unsigned axes) {
  std::vector<std::byte> colors(records.size() * kHaarAxes);
  for (std::size_t v = 0; v < records.size(); ++v) {
    const Rgb rgb = rgb_of({records[v].value(0), records[v].value(1), records[v].value(2)}, axes);
    for (std::size_t c = 0; c < kHaarAxes; ++c) colors[v * kHaarAxes + c] = static_cast<std::byte>(rgb[c]);
  }
  return colors;
}

}  // namespace deltamesh
