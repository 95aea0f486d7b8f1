// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Weights of a source as parts of 1. For writers.
#pragma once

#include <array>
#include <cmath>

#include "attributes/lattice/component_lattice.h"
#include "attributes/rows.h"
#include "attributes/skin/rows.h"

namespace deltamesh {

using Shares = std::array<double, kInfluences>;

inline double share_of(ComponentType type, std::uint64_t bits) noexcept {
  return number_of_bits(type, bits) / top_of(type);
}

inline Shares shares_at(ComponentType type, const AttributeRows& rows, std::size_t row) noexcept {
  Shares shares{};
  for (std::size_t slot = 0; slot < kInfluences; ++slot) shares[slot] = share_of(type, rows.bits(row, slot));
  return shares;
}

/// Whether they are 0 to 1, and add up to 1 about.
inline bool are_shares(const Shares& shares) noexcept {
  constexpr double kTolerance = 1e-3;
  double sum = 0;
  for (const double share : shares) {
    if (!(share >= 0 && share <= 1)) return false;
    sum += share;
  }
  return std::fabs(sum - 1) <= kTolerance;
}

}  // namespace deltamesh
