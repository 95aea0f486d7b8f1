// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Finds the coarsest lattice that keeps a bound on every value of a component: that of the bound, or one that
// the source lies on. Encoder only.
#pragma once

#include <optional>
#include <vector>

#include "attributes/lattice/component_lattice.h"
#include "attributes/rows.h"
#include "deltamesh/mesh.h"

namespace deltamesh {

/// How every component is coded, so that no value is off by more than `bound` (0: by no bit). Empty where a
/// component has too many values to list them, is not f32, and no lattice of at most kMostLatticeCells does
/// it, or has infinities or NaNs. O(n k log n).
std::optional<std::vector<ComponentLattice>> fit_lattices(const AttributeView& attribute,
                                                          const AttributeRows& rows, double bound);

}  // namespace deltamesh
