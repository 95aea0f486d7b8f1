// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "topology/weld.h"

#include <array>
#include <bit>
#include <cstddef>

namespace deltamesh {
namespace {

constexpr std::uint32_t kEmpty = 0xffffffff;

using PositionBits = std::array<std::uint32_t, 3>;

PositionBits bits_of(std::span<const float> positions, std::size_t v) noexcept {
  return {std::bit_cast<std::uint32_t>(positions[3 * v]), std::bit_cast<std::uint32_t>(positions[3 * v + 1]),
          std::bit_cast<std::uint32_t>(positions[3 * v + 2])};
}

/// Spreads all 96 bits over the upper bits of the result.
std::uint64_t hash_of(const PositionBits& bits) noexcept {
  std::uint64_t hash = 0;
  for (const std::uint32_t word : bits) {
    hash = (hash ^ word) * 0x9e3779b97f4a7c15ULL;
    hash ^= hash >> 32;
  }
  return hash * 0xd6e8feb86659fd93ULL;
}

}  // namespace

Weld weld_by_position(std::span<const float> positions, std::span<const std::uint8_t> welds) {
  const std::size_t n = welds.size();
  Weld weld;
  weld.geometric.resize(n);
  weld.representative.reserve(n);

  // Open addressing with linear probing, at most half full; a slot holds a geometric vertex.
  const std::size_t slots = std::bit_ceil(2 * n + 2);
  const int shift = 64 - std::countr_zero(slots);
  std::vector<std::uint32_t> table(slots, kEmpty);
  for (std::size_t v = 0; v < n; ++v) {
    const auto fresh = static_cast<std::uint32_t>(weld.representative.size());
    std::uint32_t found = kEmpty;
    if (welds[v] != 0) {
      const PositionBits bits = bits_of(positions, v);
      std::size_t slot = static_cast<std::size_t>(hash_of(bits) >> shift);
      while (table[slot] != kEmpty && bits_of(positions, weld.representative[table[slot]]) != bits)
        slot = (slot + 1) & (slots - 1);
      found = table[slot];
      if (found == kEmpty) table[slot] = fresh;
    }
    if (found == kEmpty) {
      weld.representative.push_back(static_cast<std::uint32_t>(v));
      found = fresh;
    }
    weld.geometric[v] = found;
  }
  return weld;
}

}  // namespace deltamesh
