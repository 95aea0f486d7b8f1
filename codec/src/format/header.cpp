// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "format/header.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "base/byte_writer.h"
#include "deltamesh/version.h"

namespace deltamesh {
namespace {

// Bits of a predictive stream's layout byte [HDR-14].
constexpr std::uint8_t kLayoutSteps = 1U << 0;   ///< three steps, not one
constexpr std::uint8_t kLayoutOrigin = 1U << 1;  ///< an origin other than the box's lowest corner
constexpr std::uint8_t kKnownLayout = kLayoutSteps | kLayoutOrigin;

/// Writes each field it visits.
struct FieldWriter {
  ByteWriter& out;
  template <class T>
  Result<void> fixed(const T& field) const {
    if constexpr (std::is_enum_v<T>) {
      out.write(static_cast<std::underlying_type_t<T>>(field));
    } else {
      out.write(field);
    }
    return {};
  }
  template <class T>
  Result<void> varint(const T& field) const {
    out.write_varint(field);
    return {};
  }
};

/// Reads each field it visits.
struct FieldReader {
  ByteReader& in;
  template <class T>
  Result<void> fixed(T& field) const {
    if constexpr (std::is_enum_v<T>) {
      DELTAMESH_TRY(const auto value, in.read<std::underlying_type_t<T>>());
      field = static_cast<T>(value);
    } else {
      DELTAMESH_TRY(field, in.read<T>());
    }
    return {};
  }
  template <class T>
  Result<void> varint(T& field) const {
    DELTAMESH_TRY(const auto value, in.read_varint(std::numeric_limits<T>::max()));
    field = static_cast<T>(value);
    return {};
  }
};

template <class Visitor, class Parameters>
Result<void> visit_highpass(const Visitor& visit, Parameters& p) {
  DELTAMESH_CHECK(visit.fixed(p.bits));
  DELTAMESH_CHECK(visit.fixed(p.step));
  DELTAMESH_CHECK(visit.fixed(p.shift.one));
  DELTAMESH_CHECK(visit.fixed(p.shift.more));
  DELTAMESH_CHECK(visit.fixed(p.anchor_bits));
  DELTAMESH_CHECK(visit.varint(p.anchors));
  DELTAMESH_CHECK(visit.varint(p.anchor_density));
  DELTAMESH_CHECK(visit.fixed(p.cycles));
  return {};
}

/// What is left out of a lattice's fields [HDR-14].
std::uint8_t lattice_layout(const FileHeader& h) noexcept {
  const PositionLattice& lattice = h.predictive.lattice;
  const bool one_step = lattice.step[0] == lattice.step[1] && lattice.step[1] == lattice.step[2];
  return static_cast<std::uint8_t>((one_step ? 0 : kLayoutSteps) |
                                   (lattice.origin == h.box().min ? 0 : kLayoutOrigin));
}

/// `layout` is the writer's; a reader's own takes its place.
template <class Visitor, class Header>
Result<void> visit_predictive(const Visitor& visit, Header& h) {
  auto& p = h.predictive;
  std::uint8_t layout = lattice_layout(h);
  DELTAMESH_CHECK(visit.fixed(p.bits));
  DELTAMESH_CHECK(visit.fixed(p.kind));
  if (p.kind == PositionKind::kFloats) return {};
  DELTAMESH_CHECK(visit.fixed(layout));
  DELTAMESH_CHECK(visit.fixed(p.lattice.step[0]));
  if ((layout & kLayoutSteps) != 0) {
    DELTAMESH_CHECK(visit.fixed(p.lattice.step[1]));
    DELTAMESH_CHECK(visit.fixed(p.lattice.step[2]));
  }
  if ((layout & kLayoutOrigin) != 0) {
    for (auto& x : p.lattice.origin) DELTAMESH_CHECK(visit.fixed(x));
  }
  for (auto& count : p.lattice.cells) DELTAMESH_CHECK(visit.varint(count));
  if (p.kind == PositionKind::kVoxel) DELTAMESH_CHECK(visit.varint(p.levels));
  if constexpr (!std::is_const_v<Header>) {
    if ((layout & ~kKnownLayout) != 0) p.lattice.step[0] = 0;  // out of range, like every field that is wrong
    if ((layout & kLayoutSteps) == 0) p.lattice.step.fill(p.lattice.step[0]);
    if ((layout & kLayoutOrigin) == 0) p.lattice.origin = h.box().min;
  }
  return {};
}

/// Every field after the flags, in stream order, for both directions, so that they cannot drift.
template <class Visitor, class Header>
Result<void> visit_fields(const Visitor& visit, Header& h, bool has_origin) {
  DELTAMESH_CHECK(visit.varint(h.vertices));
  DELTAMESH_CHECK(visit.varint(h.geometric_vertices));
  DELTAMESH_CHECK(visit.varint(h.triangles));
  DELTAMESH_CHECK(visit.varint(h.components));
  DELTAMESH_CHECK(visit.varint(h.attributes));
  if (has_origin) {
    for (auto& x : h.origin) DELTAMESH_CHECK(visit.fixed(x));
  }
  for (auto& x : h.box_min) DELTAMESH_CHECK(visit.fixed(x));
  for (auto& x : h.box_max) DELTAMESH_CHECK(visit.fixed(x));
  DELTAMESH_CHECK(visit.fixed(h.vde_rms));
  DELTAMESH_CHECK(visit.fixed(h.lfe_rms));
  DELTAMESH_CHECK(visit.fixed(h.max_error));
  DELTAMESH_CHECK(visit.fixed(h.geometry));
  return h.geometry == kGeometryPredictive ? visit_predictive(visit, h) : visit_highpass(visit, h.highpass);
}

Result<void> check_counts(const FileHeader& h, const ByteReader& in) {
  const auto invalid = [&in](const char* message, const char* rule) {
    return in.error(ErrorCode::kInvalidStream, message, rule);
  };
  if (h.vertices > kMaxVertices || h.triangles > kMaxTriangles)
    return invalid("more than 2^31 - 1 vertices or 2^29 triangles", "HDR-6");
  if (h.geometric_vertices > h.vertices || (h.geometric_vertices == 0) != (h.vertices == 0))
    return invalid("more geometric vertices than vertices, or none", "HDR-7");
  if (h.vertices == 0 && h.triangles != 0) return invalid("triangles without vertices", "HDR-7");
  if (h.components > h.geometric_vertices || (h.components == 0) != (h.vertices == 0))
    return invalid("more components than vertices, or none", "HDR-7");
  return {};
}

Result<void> check_numbers(const FileHeader& h, const ByteReader& in) {
  const auto invalid = [&in](const char* message, const char* rule) {
    return in.error(ErrorCode::kInvalidStream, message, rule);
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!std::isfinite(h.origin[axis])) return invalid("the origin is not finite", "HDR-8");
    if (!std::isfinite(h.box_min[axis]) || !std::isfinite(h.box_max[axis]) ||
        h.box_min[axis] > h.box_max[axis])
      return invalid("the bounding box is not finite and ordered", "HDR-8");
  }
  for (const float figure : {h.vde_rms, h.lfe_rms, h.max_error}) {
    if (!std::isfinite(figure) || figure < 0)
      return invalid("a quality figure is not a number of at least 0", "HDR-9");
  }
  return {};
}

Result<void> check_predictive(const FileHeader& h, const ByteReader& in) {
  const PredictiveParameters& p = h.predictive;
  bool in_range = p.bits <= 28 && p.kind <= PositionKind::kFloats && p.levels >= 1 && p.levels <= kMostLevels;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double step = p.lattice.step[axis];
    in_range = in_range && std::isfinite(step) && step > 0 && std::isfinite(p.lattice.origin[axis]) &&
               p.lattice.cells[axis] <= kMostCells;
  }
  if (!in_range)
    return in.error(ErrorCode::kInvalidStream, "a parameter of the predictive coder is out of range",
                    "HDR-14");
  return {};
}

Result<void> check_geometry(const FileHeader& h, const ByteReader& in) {
  const HighpassParameters& p = h.highpass;
  if (h.geometry == kGeometryPredictive) return check_predictive(h, in);
  if (h.geometry != kGeometryHighpass)
    return in.error(ErrorCode::kUnsupportedFeature, "a geometry coder that this library does not know",
                    "HDR-10");
  const bool in_range = (p.bits == 0 || (p.bits >= 3 && p.bits <= 16)) && std::isfinite(p.step) &&
                        p.step > 0 && p.anchor_bits >= 4 && p.anchor_bits <= 24 &&
                        p.anchors <= h.geometric_vertices && p.anchors >= h.components &&
                        p.cycles <= kMostCycles;
  if (!in_range)
    return in.error(ErrorCode::kInvalidStream, "a parameter of the highpass coder is out of range", "HDR-11");
  return {};
}

}  // namespace

Box FileHeader::box() const noexcept {
  return {{box_min[0], box_min[1], box_min[2]}, {box_max[0], box_max[1], box_max[2]}};
}

std::vector<std::byte> write_header(const FileHeader& header) {
  const bool has_origin = header.origin != std::array<double, 3>{};
  ByteWriter fields;
  (void)visit_fields(FieldWriter{fields}, header, has_origin);  // writing cannot fail
  ByteWriter out;
  out.write(kMagic);
  out.write(kFormatMajor);
  out.write(kFormatMinor);
  out.write(kFormatDraft);
  out.write(static_cast<std::uint16_t>(fields.size()));
  out.write(static_cast<std::uint16_t>((header.keeps_order ? kFlagKeepsOrder : 0) |
                                       (has_origin ? kFlagHasOrigin : 0)));
  out.write_bytes(fields.bytes());
  return out.take();
}

Result<FileHeader> read_header(ByteReader& in) {
  FileHeader header;
  DELTAMESH_TRY(const auto magic, in.read<std::uint32_t>());
  if (magic != kMagic) return in.error(ErrorCode::kBadMagic, "not a deltamesh stream", "HDR-1");
  DELTAMESH_TRY(header.format_major, in.read<std::uint8_t>());
  DELTAMESH_TRY(header.format_minor, in.read<std::uint8_t>());
  if (header.format_major != kFormatMajor)
    return in.error(ErrorCode::kUnsupportedVersion, "a format version that this library does not read",
                    "HDR-2");
  DELTAMESH_TRY(header.format_draft, in.read<std::uint16_t>());
  if (header.format_draft != kFormatDraft)
    return in.error(ErrorCode::kUnsupportedVersion, "another draft of the unreleased format", "HDR-3");
  DELTAMESH_TRY(const auto field_bytes, in.read<std::uint16_t>());
  DELTAMESH_TRY(const auto flags, in.read<std::uint16_t>());
  if ((flags & ~kKnownFlags) != 0)
    return in.error(ErrorCode::kInvalidStream, "a reserved flag is set", "HDR-5");
  header.keeps_order = (flags & kFlagKeepsOrder) != 0;

  const std::size_t begin = in.position();
  DELTAMESH_CHECK(visit_fields(FieldReader{in}, header, (flags & kFlagHasOrigin) != 0));
  const std::size_t used = in.position() - begin;
  if (used > field_bytes || (used < field_bytes && header.format_minor <= kFormatMinor))
    return in.error(ErrorCode::kInvalidStream, "the header's length does not fit its fields", "HDR-4");
  DELTAMESH_TRY([[maybe_unused]] const auto later_fields, in.read_bytes(field_bytes - used));

  DELTAMESH_CHECK(check_counts(header, in));
  DELTAMESH_CHECK(check_numbers(header, in));
  DELTAMESH_CHECK(check_geometry(header, in));
  return header;
}

}  // namespace deltamesh
