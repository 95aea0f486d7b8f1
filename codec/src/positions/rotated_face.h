// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Faces rotated so that the corner with the highest number comes first: when vertices are coded by number, a
// face is known at that corner.
#pragma once

#include <cstdint>

namespace deltamesh {

struct RotatedFace {
  std::uint32_t last;  ///< the corner with the highest number
  std::uint32_t a;     ///< the one after it
  std::uint32_t b;     ///< the one before it

  /// Its corners are three vertices.
  bool is_whole() const noexcept { return a != b && a != last && b != last; }
};

/// is_so ? then : otherwise, without a branch.
constexpr std::uint32_t choose(bool is_so, std::uint32_t then, std::uint32_t otherwise) noexcept {
  return otherwise ^ ((then ^ otherwise) & (0U - static_cast<std::uint32_t>(is_so)));
}

/// The face x, y, z, rotated. No branches, as they would often be mispredicted; a table takes twice the time.
constexpr RotatedFace rotated_face(std::uint32_t x, std::uint32_t y, std::uint32_t z) noexcept {
  const bool is_y = y > x;
  const std::uint32_t later = choose(is_y, y, x);
  const bool is_z = z > later;
  const std::uint32_t last = choose(is_z, z, later);
  const std::uint32_t a = choose(is_z, x, choose(is_y, z, y));
  return {last, a, x ^ y ^ z ^ last ^ a};
}

}  // namespace deltamesh
