// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>
#include <span>

#include "format/field_io.h"
#include "format/header_checks.h"
#include "format/header_fields.h"
#include "format/header_flags.h"

namespace deltamesh {
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
