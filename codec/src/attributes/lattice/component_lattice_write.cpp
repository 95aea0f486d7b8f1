// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <cmath>
#include <span>

#include "attributes/lattice/component_lattice.h"
#include "base/numbers/zigzag.h"

namespace deltamesh {

std::int64_t ComponentLattice::nearest(double x) const noexcept {
  const double place = x * static_cast<double>(over) / static_cast<double>(times);
  return static_cast<std::int64_t>(std::floor(place + 0.5)) - base;
}

void write_lattice_fields(ByteWriter& out, ComponentType type, const ComponentLattice& lattice,
                          const ComponentLattice* before) {
  if (lattice.kind != LatticeKind::kPoints) {
    out.write(static_cast<std::uint8_t>(lattice.kind));
    if (lattice.is_floats()) out.write(lattice.exponent);
    if (lattice.kind == LatticeKind::kListed) out.write_varint(lattice.values.size());
    for (const std::uint64_t bits : lattice.values)
      out.write_bytes(std::as_bytes(std::span(&bits, 1)).first(component_size(type)));
    return;
  }
  if (before != nullptr && before->times == lattice.times && before->over == lattice.over) {
    out.write(std::uint8_t{kAsBefore});
  } else {
    out.write(std::uint8_t{lattice.over == 1 ? kTimes : kRatio});
    out.write(lattice.times);
    if (lattice.over != 1) out.write(lattice.over);
  }
  out.write_varint(zigzag(lattice.base));
  out.write_varint(lattice.cells);
}

}  // namespace deltamesh
