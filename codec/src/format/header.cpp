// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "format/header.h"

#include <algorithm>
#include <limits>
#include <span>
#include <type_traits>

#include "base/byte_writer.h"
#include "base/short_float.h"
#include "base/zigzag.h"
#include "format/header_checks.h"

namespace deltamesh {
namespace {

// Bits of the flags [HDR-5].
constexpr std::uint8_t kFlagKeepsOrder = 1U << 0;
constexpr std::uint8_t kFlagOrigin = 1U << 1;         ///< of the mesh
constexpr std::uint8_t kFlagBits = 1U << 2;           ///< that were asked for
constexpr std::uint8_t kFlagLongSteps = 1U << 3;      ///< f64, not short floats
constexpr std::uint8_t kFlagThreeSteps = 1U << 4;     ///< of a lattice, one for each axis
constexpr std::uint8_t kFlagLatticeOrigin = 1U << 5;  ///< other than 0, 0, 0
constexpr unsigned kGeometryShift = 6;                ///< the two highest bits say how positions are coded

/// How positions are coded, as the two highest flags have it [HDR-5].
enum class Geometry : std::uint8_t { kHighpass, kLattice, kVoxel, kFloats };

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

Geometry geometry_of(const FileHeader& h) noexcept {
  if (h.geometry == kGeometryHighpass) return Geometry::kHighpass;
  return static_cast<Geometry>(1 + static_cast<unsigned>(h.predictive.kind));
}

bool has_lattice(Geometry geometry) noexcept {
  return geometry == Geometry::kLattice || geometry == Geometry::kVoxel;
}

bool has_one_step(const PositionLattice& lattice) noexcept {
  return lattice.step[0] == lattice.step[1] && lattice.step[1] == lattice.step[2];
}

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

template <class Visitor, class Step>
Result<void> visit_step(const Visitor& visit, std::uint8_t flags, Step& step) {
  if ((flags & kFlagLongSteps) != 0) return visit.fixed(step);
  auto short_step = static_cast<float>(step);
  DELTAMESH_CHECK(visit.short_float(short_step));
  if constexpr (!std::is_const_v<Step>) step = short_step;
  return {};
}

template <class Visitor, class Parameters>
Result<void> visit_highpass(const Visitor& visit, std::uint8_t flags, Parameters& p) {
  DELTAMESH_CHECK(visit_step(visit, flags, p.step));
  DELTAMESH_CHECK(visit.fixed(p.shift.one));
  DELTAMESH_CHECK(visit.fixed(p.shift.more));
  DELTAMESH_CHECK(visit.fixed(p.anchor_bits));
  DELTAMESH_CHECK(visit.varint(p.anchors));
  DELTAMESH_CHECK(visit.varint(p.anchor_density));
  return visit.fixed(p.cycles);
}

template <class Visitor, class Lattice>
Result<void> visit_lattice(const Visitor& visit, std::uint8_t flags, Lattice& lattice) {
  DELTAMESH_CHECK(visit_step(visit, flags, lattice.step[0]));
  if ((flags & kFlagThreeSteps) != 0) {
    DELTAMESH_CHECK(visit_step(visit, flags, lattice.step[1]));
    DELTAMESH_CHECK(visit_step(visit, flags, lattice.step[2]));
  } else if constexpr (!std::is_const_v<Lattice>) {
    lattice.step.fill(lattice.step[0]);
  }
  if ((flags & kFlagLatticeOrigin) != 0) {
    for (auto& x : lattice.origin) DELTAMESH_CHECK(visit.fixed(x));
  }
  for (auto& first : lattice.first) DELTAMESH_CHECK(visit.varint(first));
  for (auto& count : lattice.cells) DELTAMESH_CHECK(visit.varint(count));
  return {};
}

template <class Visitor, class Header>
Result<void> visit_box(const Visitor& visit, Header& h) {
  for (auto& x : h.box_min) DELTAMESH_CHECK(visit.fixed(x));
  for (auto& x : h.box_max) DELTAMESH_CHECK(visit.fixed(x));
  return {};
}

template <class Visitor, class Header>
Result<void> visit_counts(const Visitor& visit, Header& h) {
  std::uint32_t copies = h.vertices - h.geometric_vertices;
  DELTAMESH_CHECK(visit.varint(h.triangles));
  DELTAMESH_CHECK(visit.varint(h.geometric_vertices));
  DELTAMESH_CHECK(visit.varint(copies));
  DELTAMESH_CHECK(visit.varint(h.components));
  if constexpr (!std::is_const_v<Header>) {
    const std::uint64_t all = std::uint64_t{h.geometric_vertices} + copies;
    h.vertices = static_cast<std::uint32_t>(std::min<std::uint64_t>(all, 0xffffffff));  // which HDR-6 forbids
  }
  return {};
}

/// Every field after the flags, in stream order, for both directions, so that they cannot drift.
template <class Visitor, class Header>
Result<void> visit_fields(const Visitor& visit, std::uint8_t flags, Header& h) {
  const Geometry geometry = geometry_of(h);
  DELTAMESH_CHECK(visit_counts(visit, h));
  if ((flags & kFlagOrigin) != 0) {
    for (auto& x : h.origin) DELTAMESH_CHECK(visit.fixed(x));
  }
  DELTAMESH_CHECK(visit.short_float(h.vde_rms));
  DELTAMESH_CHECK(visit.short_float(h.lfe_rms));
  DELTAMESH_CHECK(visit.short_float(h.max_error));
  if ((flags & kFlagBits) != 0)
    DELTAMESH_CHECK(visit.fixed(geometry == Geometry::kHighpass ? h.highpass.bits : h.predictive.bits));
  if (!has_lattice(geometry)) DELTAMESH_CHECK(visit_box(visit, h));
  if (geometry == Geometry::kHighpass) return visit_highpass(visit, flags, h.highpass);
  if (has_lattice(geometry)) DELTAMESH_CHECK(visit_lattice(visit, flags, h.predictive.lattice));
  return geometry == Geometry::kVoxel ? visit.varint(h.predictive.levels) : Result<void>();
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
  (void)visit_fields(FieldWriter{out}, flags, header);  // writing cannot fail
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
