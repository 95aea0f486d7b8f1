// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The header's flags, and its fields in stream order, for both directions, so that they cannot drift [HDR-5].
#pragma once

#include <algorithm>
#include <cstdint>
#include <type_traits>

#include "base/numbers/short_float.h"
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

/// The flags that the fields of `h` require.
inline std::uint8_t flags_of(const FileHeader& h) noexcept {
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
inline void apply_flags(std::uint8_t flags, FileHeader& h) noexcept {
  const auto geometry = static_cast<Geometry>(flags >> kGeometryShift);
  h.keeps_order = (flags & kFlagKeepsOrder) != 0;
  h.geometry = geometry == Geometry::kHighpass ? kGeometryHighpass : kGeometryPredictive;
  if (geometry != Geometry::kHighpass)
    h.predictive.kind = static_cast<PositionKind>(static_cast<unsigned>(geometry) - 1);
}

/// Flags that mean nothing with the geometry.
inline bool are_reserved_flags_set(std::uint8_t flags) noexcept {
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
void visit_step(Visitor& visit, std::uint8_t flags, Step& step) {
  if ((flags & kFlagLongSteps) != 0) return visit.fixed(step);
  auto short_step = static_cast<float>(step);
  visit.short_float(short_step);
  if constexpr (!std::is_const_v<Step>) step = short_step;
}

template <class Visitor, class Parameters>
void visit_highpass(Visitor& visit, std::uint8_t flags, Parameters& p) {
  visit_step(visit, flags, p.step);
  visit.fixed(p.shift.one);
  visit.fixed(p.shift.more);
  visit.fixed(p.anchor_bits);
  visit.varint(p.anchors);
  visit.varint(p.anchor_density);
  return visit.fixed(p.cycles);
}

template <class Visitor, class Lattice>
void visit_lattice(Visitor& visit, std::uint8_t flags, Lattice& lattice) {
  visit_step(visit, flags, lattice.step[0]);
  if ((flags & kFlagThreeSteps) != 0) {
    visit_step(visit, flags, lattice.step[1]);
    visit_step(visit, flags, lattice.step[2]);
  } else if constexpr (!std::is_const_v<Lattice>) {
    lattice.step.fill(lattice.step[0]);
  }
  if ((flags & kFlagLatticeOrigin) != 0) {
    for (auto& x : lattice.origin) visit.fixed(x);
  }
  for (auto& first : lattice.first) visit.varint(first);
  for (auto& count : lattice.cells) visit.varint(count);
}

template <class Visitor, class Header>
void visit_box(Visitor& visit, Header& h) {
  for (auto& x : h.box_min) visit.fixed(x);
  for (auto& x : h.box_max) visit.fixed(x);
}

template <class Visitor, class Header>
void visit_counts(Visitor& visit, Header& h) {
  std::uint32_t copies = h.vertices - h.geometric_vertices;
  visit.varint(h.triangles);
  visit.varint(h.geometric_vertices);
  visit.varint(copies);
  visit.varint(h.components);
  if constexpr (!std::is_const_v<Header>) {
    const std::uint64_t all = std::uint64_t{h.geometric_vertices} + copies;
    h.vertices = static_cast<std::uint32_t>(std::min<std::uint64_t>(all, 0xffffffff));  // which HDR-6 forbids
  }
}

/// Every field after the flags.
template <class Visitor, class Header>
void visit_fields(Visitor& visit, std::uint8_t flags, Header& h) {
  const Geometry geometry = geometry_of(h);
  visit_counts(visit, h);
  if ((flags & kFlagOrigin) != 0) {
    for (auto& x : h.origin) visit.fixed(x);
  }
  visit.short_float(h.vde_rms);
  visit.short_float(h.lfe_rms);
  visit.short_float(h.max_error);
  if ((flags & kFlagBits) != 0)
    visit.fixed(geometry == Geometry::kHighpass ? h.highpass.bits : h.predictive.bits);
  if (!has_lattice(geometry)) visit_box(visit, h);
  if (geometry == Geometry::kHighpass) return visit_highpass(visit, flags, h.highpass);
  if (has_lattice(geometry)) visit_lattice(visit, flags, h.predictive.lattice);
  if (geometry == Geometry::kVoxel) visit.varint(h.predictive.levels);
}

}  // namespace deltamesh
