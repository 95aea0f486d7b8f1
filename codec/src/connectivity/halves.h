// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Large meshes are coded in two halves that know nothing of each other, so that two threads can read them
// [CONN-15].
#pragma once

#include <cstdint>
#include <vector>

#include "connectivity/cut.h"

namespace deltamesh {

/// Meshes of so many faces are large [CONN-15].
inline constexpr std::uint32_t kFewestFacesOfHalves = 1U << 19;

/// Which meshes are coded in halves: for tests, small ones too.
enum class Halving : std::uint8_t { kIfLarge, kAlways };

constexpr bool is_halved(std::uint32_t faces, Halving halving) noexcept {
  return halving == Halving::kAlways || faces >= kFewestFacesOfHalves;
}

/// Faces of the first half.
constexpr std::uint32_t first_half_of(std::uint32_t faces) noexcept { return faces - faces / 2; }

/// Which faces are of the second half: few half-edges run between the halves, as the first one grows face by
/// face from the first face on. Half-edges are not matched across any more: those of the second half are
/// repeated. O(faces).
std::vector<std::uint8_t> cut_in_halves(HalfEdges& half_edges);

}  // namespace deltamesh
