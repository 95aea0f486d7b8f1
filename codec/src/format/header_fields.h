// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The header's fields in stream order, for both directions, so that they cannot drift [HDR-5].
#pragma once

#include <algorithm>
#include <cstdint>
#include <type_traits>

#include "format/header.h"

namespace deltamesh {

// Bits of the flags [HDR-5].
inline constexpr std::uint8_t kFlagKeepsOrder = 1U << 0;
inline constexpr std::uint8_t kFlagOrigin = 1U << 1;         ///< of the mesh
inline constexpr std::uint8_t kFlagBits = 1U << 2;           ///< that were asked for
inline constexpr std::uint8_t kFlagLongSteps = 1U << 3;      ///< f64, not short floats
inline constexpr std::uint8_t kFlagThreeSteps = 1U << 4;     ///< of a lattice, one for each axis
inline constexpr std::uint8_t kFlagLatticeOrigin = 1U << 5;  ///< other than 0, 0, 0
inline constexpr unsigned kGeometryShift = 6;  ///< the two highest bits say how positions are coded

/// How positions are coded, as the two highest flags have it [HDR-5].
enum class Geometry : std::uint8_t { kHighpass, kLattice, kVoxel, kFloats };

inline Geometry geometry_of(const FileHeader& h) noexcept {
  if (h.geometry == kGeometryHighpass) return Geometry::kHighpass;
  return static_cast<Geometry>(1 + static_cast<unsigned>(h.predictive.kind));
}

inline bool has_lattice(Geometry geometry) noexcept {
  return geometry == Geometry::kLattice || geometry == Geometry::kVoxel;
}

inline bool has_one_step(const PositionLattice& lattice) noexcept {
  return lattice.step[0] == lattice.step[1] && lattice.step[1] == lattice.step[2];
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

/// Every field after the flags.
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

}  // namespace deltamesh
