// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "format/header.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "base/byte_writer.h"
#include "format/field_io.h"
#include "format/header_fields.h"

namespace deltamesh {
namespace {

Result<void> check_counts(const FileHeader& h, const ByteReader& in) {
  if (h.vertices > kMaxVertices || h.triangles > kMaxTriangles)
    return in.invalid("more than 2^31 - 1 vertices or 2^29 triangles", "HDR-6");
  if ((h.geometric_vertices == 0) != (h.vertices == 0))
    return in.invalid("vertices without geometric vertices", "HDR-7");
  if (h.vertices == 0 && h.triangles != 0) return in.invalid("triangles without vertices", "HDR-7");
  if (h.components > h.geometric_vertices || (h.components == 0) != (h.vertices == 0))
    return in.invalid("more components than vertices, or none", "HDR-7");
  return {};
}

Result<void> check_numbers(const FileHeader& h, const ByteReader& in) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!std::isfinite(h.origin[axis])) return in.invalid("the origin is not finite", "HDR-8");
    if (!std::isfinite(h.box_min[axis]) || !std::isfinite(h.box_max[axis]) ||
        h.box_min[axis] > h.box_max[axis])
      return in.invalid("the bounding box is not finite and ordered", "HDR-8");
  }
  for (const float figure : {h.vde_rms, h.lfe_rms, h.max_error}) {
    if (!std::isfinite(figure) || figure < 0)
      return in.invalid("a quality figure is not a number of at least 0", "HDR-9");
  }
  return {};
}

bool is_step(double step) noexcept { return std::isfinite(step) && step > 0; }

Result<void> check_highpass(const FileHeader& h, const ByteReader& in) {
  const HighpassParameters& p = h.highpass;
  const bool in_range = (p.bits == 0 || (p.bits >= 3 && p.bits <= 16)) && is_step(p.step) &&
                        p.anchor_bits >= kLeastAnchorBits && p.anchor_bits <= kMostAnchorBits &&
                        p.anchors <= h.geometric_vertices && p.anchors >= h.components && p.cycles >= 1 &&
                        p.cycles <= kMostCycles;
  if (!in_range) return in.invalid("a parameter of the highpass coder is out of range", "HDR-11");
  return {};
}

Result<void> check_predictive(const FileHeader& h, const ByteReader& in) {
  const PredictiveParameters& p = h.predictive;
  bool in_range = p.bits <= 28 && p.levels >= 1 && p.levels <= kMostLevels;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const PositionLattice& lattice = p.lattice;
    in_range = in_range && is_step(lattice.step[axis]) && std::isfinite(lattice.origin[axis]) &&
               lattice.first[axis] >= -kMostFirst && lattice.first[axis] <= kMostFirst &&
               lattice.cells[axis] <= kMostCells;
  }
  if (!in_range) return in.invalid("a parameter of the predictive coder is out of range", "HDR-14");
  return {};
}

/// The nearest finite float.
float to_finite_float(double value) noexcept {
  constexpr double kMost = std::numeric_limits<float>::max();
  return static_cast<float>(std::clamp(value, -kMost, kMost));
}

/// Sets the box to that of the lattice's points, as finite floats [HDR-8]. The header has passed
/// check_header.
void set_box_of_lattice(FileHeader& header) noexcept {
  const PositionLattice& lattice = header.predictive.lattice;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    header.box_min[axis] = to_finite_float(lattice.at(axis, 0));
    header.box_max[axis] = to_finite_float(lattice.at(axis, lattice.cells[axis]));
  }
}

}  // namespace

Box FileHeader::box() const noexcept {
  return {{box_min[0], box_min[1], box_min[2]}, {box_max[0], box_max[1], box_max[2]}};
}

std::vector<std::byte> write_header(const FileHeader& header) {
  ByteWriter out;
  const std::uint8_t flags = flags_of(header);
  for (const char letter : kMagic) out.write(letter);
  out.write(kFormatVersion);
  out.write(flags);
  FieldWriter fields(out);
  visit_fields(fields, flags, header);
  return out.take();
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
    return in.error(ErrorCode::kUnsupportedVersion,
                    "another draft of the unreleased format than this library reads", "HDR-3");
  return {};
}

Result<FileHeader> read_header(ByteReader& in) {
  DELTAMESH_CHECK(read_signature(in));
  FileHeader header;
  DELTAMESH_TRY(const auto flags, in.read<std::uint8_t>());
  if (are_reserved_flags_set(flags))
    return in.invalid("a flag that means nothing with this geometry", "HDR-5");
  apply_flags(flags, header);
  FieldReader fields(in);
  visit_fields(fields, flags, header);
  DELTAMESH_CHECK(fields.outcome());
  DELTAMESH_CHECK(check_header(header, in));
  if (has_lattice(geometry_of(header))) set_box_of_lattice(header);
  return header;
}

Result<void> check_header(const FileHeader& header, const ByteReader& in) {
  DELTAMESH_CHECK(check_counts(header, in));
  DELTAMESH_CHECK(check_numbers(header, in));
  return header.geometry == kGeometryPredictive ? check_predictive(header, in) : check_highpass(header, in);
}

}  // namespace deltamesh
