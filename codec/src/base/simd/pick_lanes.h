// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Lanes of vectors in another order.
#pragma once

namespace deltamesh {

/// The lanes of `a` and then of `b` at these places, of which there are as many as a vector has lanes.
template <int... kPlaces, class Lanes>
constexpr Lanes pick_lanes(Lanes a, Lanes b) noexcept {
  return __builtin_shufflevector(a, b, kPlaces...);
}
template <int... kPlaces, class Lanes>
constexpr Lanes pick_lanes(Lanes lanes) noexcept {
  return pick_lanes<kPlaces...>(lanes, lanes);
}

}  // namespace deltamesh
