// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Which whole number stands for a component's value on a lattice. Encoder only.
#pragma once

#include <cstdint>
#include <unordered_map>

#include "attributes/component_lattice.h"
#include "deltamesh/mesh.h"

namespace deltamesh {

/// The point of `lattice`, of kPoints, that is nearest to `x`.
inline std::int64_t nearest_point(const ComponentLattice& lattice, double x) noexcept {
  const double place = x * static_cast<double>(lattice.over) / static_cast<double>(lattice.times);
  const double up = place + 0.5;
  const auto whole = static_cast<std::int64_t>(up);  // rounded down where it is not below 0
  return whole - (static_cast<double>(whole) > up ? 1 : 0) - lattice.base;
}

/// The numbers of `lattice`, not of kConstant, for the values it was fitted to.
class LatticeNumbers {
 public:
  /// `lattice` must outlive it.
  LatticeNumbers(const ComponentLattice& lattice, ComponentType type);

  /// What stands for the value with these bits.
  std::int32_t of(std::uint64_t bits) const;

 private:
  const ComponentLattice& lattice_;
  ComponentType type_;
  std::unordered_map<std::uint64_t, std::int32_t> places_;  ///< in a list
};

}  // namespace deltamesh
