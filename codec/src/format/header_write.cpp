// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>
#include <type_traits>

#include "base/byte_writer.h"
#include "base/short_float.h"
#include "base/zigzag.h"
#include "format/header_fields.h"

namespace deltamesh {
namespace {

/// Writes each field it visits.
struct FieldWriter {
  ByteWriter& out;
  template <class T>
  Result<void> fixed(const T& field) const {
    out.write(field);
    return {};
  }
  Result<void> short_float(float field) const {
    out.write_short_float(field);
    return {};
  }
  template <class T>
  Result<void> varint(const T& field) const {
    if constexpr (std::is_signed_v<T>) {
      out.write_varint(zigzag(std::int64_t{field}));
    } else {
      out.write_varint(field);
    }
    return {};
  }
};

/// What the fields of `h` take.
std::uint8_t flags_of(const FileHeader& h) noexcept {
  const Geometry geometry = geometry_of(h);
  const PositionLattice& lattice = h.predictive.lattice;
  unsigned flags = static_cast<unsigned>(geometry) << kGeometryShift;
  if (h.keeps_order) flags |= kFlagKeepsOrder;
  if (h.origin != std::array<double, 3>{}) flags |= kFlagOrigin;
  if ((geometry == Geometry::kHighpass ? h.highpass.bits : h.predictive.bits) != 0) flags |= kFlagBits;
  if (geometry == Geometry::kHighpass && !is_short_float(h.highpass.step)) flags |= kFlagLongSteps;
  if (!has_lattice(geometry)) return static_cast<std::uint8_t>(flags);
  if (!std::all_of(lattice.step.begin(), lattice.step.end(), is_short_float)) flags |= kFlagLongSteps;
  if (!has_one_step(lattice)) flags |= kFlagThreeSteps;
  if (lattice.origin != Vec3{}) flags |= kFlagLatticeOrigin;
  return static_cast<std::uint8_t>(flags);
}

}  // namespace

std::vector<std::byte> write_header(const FileHeader& header) {
  ByteWriter out;
  const std::uint8_t flags = flags_of(header);
  for (const char letter : kMagic) out.write(letter);
  out.write(kFormatVersion);
  out.write(flags);
  (void)visit_fields(FieldWriter{out}, flags, header);  // writing cannot fail
  return out.take();
}

}  // namespace deltamesh
