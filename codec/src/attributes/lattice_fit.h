// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Finds the coarsest lattice that keeps a bound on every value of a component: that of the bound, or one that
// the source lies on. Encoder only.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "attributes/attribute_rows.h"
#include "attributes/component_lattice.h"
#include "deltamesh/mesh.h"

namespace deltamesh {

/// How every component is coded, so that no value is off by more than `bound` (0: by no bit). Empty where a
/// component has too many values to list them, is not f32, and no lattice of at most kMostLatticeCells does
/// it, or has infinities or NaNs. O(n k log n).
std::optional<std::vector<ComponentLattice>> fit_lattices(const AttributeView& attribute,
                                                          const AttributeRows& rows, double bound);

/// The point of `lattice`, of kPoints, that is nearest to `x`.
std::int64_t nearest_point(const ComponentLattice& lattice, double x) noexcept;

/// The numbers of `lattice`, not of kConstant, that stand for the values with these bits, which it was fitted
/// to.
std::vector<std::int32_t> numbers_on(const ComponentLattice& lattice, ComponentType type,
                                     std::span<const std::uint64_t> bits);

}  // namespace deltamesh
