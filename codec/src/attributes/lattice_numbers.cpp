// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "attributes/lattice_numbers.h"

#include <bit>

#include "predictive/float_order.h"

namespace deltamesh {

LatticeNumbers::LatticeNumbers(const ComponentLattice& lattice, ComponentType type)
    : lattice_(lattice), type_(type) {
  if (lattice.kind != LatticeKind::kListed) return;
  for (const std::uint64_t value : lattice.values)
    places_.emplace(value, static_cast<std::int32_t>(places_.size()));
}

std::int32_t LatticeNumbers::of(std::uint64_t bits) const {
  if (lattice_.is_floats()) return ordinal_of(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
  if (lattice_.kind == LatticeKind::kListed) return places_.at(bits);
  return static_cast<std::int32_t>(nearest_point(lattice_, number_of_bits(type_, bits)));
}

}  // namespace deltamesh
