// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "deltamesh/map/description.h"

#include <algorithm>
#include <cmath>

#include "format/chunk/attribute_descriptor.h"
#include "support/errors.h"
#include "support/limits.h"

namespace deltamesh {

Result<void> validate(const MapDescription& description) noexcept {
  const MapLattice& lattice = description.lattice;
  if (!std::ranges::all_of(lattice.origin, [](double x) { return std::isfinite(x); }))
    return invalid_argument("the map's origin is not finite", "MAP-2");
  if (lattice.step_exponent < kLeastStepExponent || lattice.step_exponent > kMostStepExponent)
    return invalid_argument("the lattice's step is not 2^-40 to 2^20", "MAP-2");
  if (description.cell_steps == 0 || description.cell_steps > kMostCellSteps)
    return invalid_argument("the edge of a cell is not 1 to 2^24 steps", "MAP-3");
  if (!std::ranges::all_of(description.cell_origin,
                           [](std::int32_t x) { return x >= -kMostLatticeSteps && x <= kMostLatticeSteps; }))
    return invalid_argument("the origin of cells is 2^24 steps or more off", "MAP-3");
  if (description.grid && !is_valid(*description.grid))
    return invalid_argument("a grid whose origin or edges are not finite, or whose edges are not above 0",
                            "MAP-5");
  if (description.frame.size() > kMostNameBytes)
    return invalid_argument("the name of the frame has more than 255 bytes", "MAP-5");
  if (description.attributes.size() > kMostMapAttributes)
    return invalid_argument("more than 255 attributes", "MAP-5");
  for (const MapAttribute& attribute : description.attributes) {
    if (attribute.components == 0 || attribute.components > kMaxComponents)
      return invalid_argument("an attribute has not 1 to 16 components", "MAP-5");
    if (attribute.name.size() > kMostNameBytes)
      return invalid_argument("an attribute's name has more than 255 bytes", "MAP-5");
  }
  if (description.primers.size() > kMostPrimers) return invalid_argument("more than 255 primers", "MAP-6");
  std::size_t primer_bytes = 0;
  for (const MapPrimer& primer : description.primers) {
    primer_bytes += primer.stream.size() + primer.border.size();
    if (primer.stream.empty()) return invalid_argument("a primer of no bytes", "MAP-6");
    if (primer_bytes > kMostPrimerBytes) return invalid_argument("primers of more than 65536 bytes", "MAP-6");
  }
  return {};
}

}  // namespace deltamesh
