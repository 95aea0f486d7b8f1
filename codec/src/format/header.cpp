// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <limits>
#include <span>
#include <type_traits>

#include "base/zigzag.h"
#include "format/header_checks.h"
#include "format/header_fields.h"

namespace deltamesh {
namespace {

/// Reads each field it visits.
struct FieldReader {
  ByteReader& in;
  template <class T>
  Result<void> fixed(T& field) const {
    DELTAMESH_TRY(field, in.read<T>());
    return {};
  }
  Result<void> short_float(float& field) const {
    DELTAMESH_TRY(field, in.read_short_float());
    return {};
  }
  template <class T>
  Result<void> varint(T& field) const {
    if constexpr (std::is_signed_v<T>) {
      DELTAMESH_TRY(const auto code, in.read_varint());
      field = unzigzag(code);
    } else {
      DELTAMESH_TRY(const auto value, in.read_varint(std::numeric_limits<T>::max()));
      field = static_cast<T>(value);
    }
    return {};
  }
};

/// Sets the members of `h` that the flags stand for.
void apply_flags(std::uint8_t flags, FileHeader& h) noexcept {
  const auto geometry = static_cast<Geometry>(flags >> kGeometryShift);
  h.keeps_order = (flags & kFlagKeepsOrder) != 0;
  h.geometry = geometry == Geometry::kHighpass ? kGeometryHighpass : kGeometryPredictive;
  if (geometry != Geometry::kHighpass)
    h.predictive.kind = static_cast<PositionKind>(static_cast<unsigned>(geometry) - 1);
}

/// Flags that mean nothing with the geometry.
bool are_reserved_flags_set(std::uint8_t flags) noexcept {
  constexpr unsigned kOfLattices = kFlagThreeSteps | kFlagLatticeOrigin;
  switch (static_cast<Geometry>(flags >> kGeometryShift)) {
    case Geometry::kHighpass:
      return (flags & kOfLattices) != 0;
    case Geometry::kFloats:
      return (flags & (kOfLattices | kFlagLongSteps)) != 0;
    case Geometry::kLattice:
    case Geometry::kVoxel:
      break;
  }
  return false;
}

}  // namespace

Box FileHeader::box() const noexcept {
  return {{box_min[0], box_min[1], box_min[2]}, {box_max[0], box_max[1], box_max[2]}};
}

Result<void> read_signature(ByteReader& in) {
  DELTAMESH_TRY(const auto magic, in.read_bytes(kMagic.size()));
  const auto expected = std::as_bytes(std::span(kMagic));
  if (!std::equal(magic.begin(), magic.end(), expected.begin(), expected.end()))
    return in.error(ErrorCode::kBadMagic, "not a deltamesh stream", "HDR-1");
  DELTAMESH_TRY(const auto version, in.read<std::uint8_t>());
  if (version < kFirstDraft && version != kFormatVersion)
    return in.error(ErrorCode::kUnsupportedVersion, "a format version that this library does not read",
                    "HDR-2");
  if (version != kFormatVersion)
    return in.error(ErrorCode::kUnsupportedVersion, "another draft of the unreleased format", "HDR-3");
  return {};
}

Result<FileHeader> read_header(ByteReader& in) {
  DELTAMESH_CHECK(read_signature(in));
  FileHeader header;
  DELTAMESH_TRY(const auto flags, in.read<std::uint8_t>());
  if (are_reserved_flags_set(flags))
    return in.error(ErrorCode::kInvalidStream, "a flag that means nothing with this geometry", "HDR-5");
  apply_flags(flags, header);
  DELTAMESH_CHECK(visit_fields(FieldReader{in}, flags, header));
  DELTAMESH_CHECK(check_header(header, in));
  if (has_lattice(geometry_of(header))) set_box_of_lattice(header);
  return header;
}

}  // namespace deltamesh
