// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "connectivity/halves.h"

#include <cstddef>

namespace deltamesh {

std::vector<std::uint8_t> cut_in_halves(HalfEdges& half_edges) {
  std::vector<std::uint32_t>& opposite = half_edges.opposite;
  const auto faces = static_cast<std::uint32_t>(opposite.size() / 3);
  std::vector<std::uint8_t> is_second(faces, 1);
  std::vector<std::uint32_t> first_half;
  first_half.reserve(first_half_of(faces));
  const auto take = [&](std::uint32_t face) {
    if (is_second[face] == 0 || first_half.size() == first_half_of(faces)) return;
    is_second[face] = 0;
    first_half.push_back(face);
  };
  std::size_t grown = 0;
  for (std::uint32_t seed = 0; first_half.size() < first_half_of(faces); ++seed) {
    take(seed);
    for (; grown < first_half.size(); ++grown) {
      for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t across = opposite[3 * first_half[grown] + k];
        if (across != kNoIndex) take(across / 3);
      }
    }
  }
  for (const std::uint32_t face : first_half) {
    for (std::uint32_t h = 3 * face; h < 3 * face + 3; ++h) {
      const std::uint32_t across = opposite[h];
      if (across == kNoIndex || is_second[across / 3] == 0) continue;
      opposite[h] = opposite[across] = kNoIndex;
      half_edges.repeated.push_back(across);
    }
  }
  return is_second;
}

}  // namespace deltamesh
