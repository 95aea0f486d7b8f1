// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Candidates in the search for matching faces of two meshes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <tuple>

namespace deltamesh {

/// The claim that a face of B is a face of A.
struct Claim {
  std::uint8_t conflicts = 0;  ///< corners that earlier matches put elsewhere
  std::uint8_t doubt = 0;  ///< 0 across an edge of the same vertices, 1 of the same places, 2 with a choice
  std::uint8_t rotation = 0;
  double cost = 0;        ///< sum of the corners' squared distances
  double difference = 0;  ///< of the corners' attributes; only where there is a choice
  std::uint32_t b = 0;
  std::uint32_t a = 0;

  bool operator>(const Claim& other) const noexcept {
    return std::tie(conflicts, doubt, cost, difference, b, a, rotation) >
           std::tie(other.conflicts, other.doubt, other.cost, other.difference, other.b, other.a,
                    other.rotation);
  }
};

/// Whether a start with `x` fits better than with `y`.
inline bool nearer(const Claim& x, const Claim& y) noexcept {
  return std::tie(x.cost, x.difference, x.a, x.rotation) < std::tie(y.cost, y.difference, y.a, y.rotation);
}

/// Rotation of a match where corner `b_corner` of B's face is `a_corner` of A's.
inline std::uint8_t rotation_between(std::size_t b_corner, std::size_t a_corner) noexcept {
  return static_cast<std::uint8_t>((a_corner + 3 - b_corner) % 3);
}

}  // namespace deltamesh
