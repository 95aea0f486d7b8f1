// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Positions by their bits.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "deltamesh/map/description.h"
#include "deltamesh/mesh.h"

namespace deltamesh {

using PositionBits = std::array<std::uint32_t, 3>;

inline PositionBits position_bits(const float* p) noexcept {
  return {std::bit_cast<std::uint32_t>(p[0]), std::bit_cast<std::uint32_t>(p[1]),
          std::bit_cast<std::uint32_t>(p[2])};
}
inline PositionBits bits_of(const Mesh& mesh, std::size_t vertex) noexcept {
  return position_bits(mesh.positions.data() + 3 * vertex);
}

inline LatticePoint point_of(const PositionBits& bits, const MapLattice& lattice) noexcept {
  return lattice.nearest(
      {std::bit_cast<float>(bits[0]), std::bit_cast<float>(bits[1]), std::bit_cast<float>(bits[2])});
}

/// Of positions and of lattice points.
struct PositionHash {
  template <class T>
  std::size_t operator()(const std::array<T, 3>& x) const noexcept {
    std::uint64_t hash = 0;
    for (const T k : x) {
      hash = (hash ^ static_cast<std::uint32_t>(k)) * 0x9E3779B97F4A7C15U;
      hash ^= hash >> 32;
    }
    return static_cast<std::size_t>(hash);
  }
};

}  // namespace deltamesh
