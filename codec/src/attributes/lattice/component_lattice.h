// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The lattice that one component of an attribute lies on, and its fields in a payload [ATTR-55].
#pragma once

#include <cstdint>
#include <vector>

#include "base/byte_reader.h"
#include "base/byte_writer.h"
#include "base/component.h"
#include "deltamesh/mesh.h"
#include "deltamesh/result.h"

namespace deltamesh {

inline constexpr std::int64_t kLargestLatticeBase = std::int64_t{1} << 52;  ///< either sign
inline constexpr std::uint32_t kMostLatticeCells = 1U << 28;

/// How a component's coded integers map to values [ATTR-55].
enum class LatticeKind : std::uint8_t {
  kConstant = 0,  ///< nothing is coded: one value alone
  kPoints = 1,    ///< of (base + q) * times / over
  kListed = 4,    ///< of a list of values
  kFloats = 5,    ///< f32 to the last bit, as ordinals [FLT-1]
};

/// The first field of a component with LatticeKind::kPoints.
enum PointsField : std::uint8_t {
  kAsBefore = 1,  ///< `times` and `over` are those of the component before
  kTimes = 2,     ///< `times` follows, `over` is 1
  kRatio = 3,     ///< `times` and `over` follow
};

/// The longest list of values. Longer lists do not pay.
inline constexpr std::uint32_t kMostListed = 4096;

struct ComponentLattice {
  LatticeKind kind = LatticeKind::kConstant;
  std::vector<std::uint64_t> values = {};  ///< bits of the constant, or of the list, 1 to kMostListed
  float times = 1;                         ///< finite, above 0
  float over = 1;                          ///< likewise
  std::int64_t base = 0;                   ///< at most kLargestLatticeBase in size
  std::uint32_t cells = 0;                 ///< the largest number; at most kMostLatticeCells. Not of floats
  std::uint8_t exponent = 0;               ///< of the largest float, as its bits have it; below 255

  bool operator==(const ComponentLattice&) const = default;

  bool is_constant() const noexcept { return kind == LatticeKind::kConstant; }
  bool is_floats() const noexcept { return kind == LatticeKind::kFloats; }
  /// kPoints only: the value of `q`. The order of operations is fixed, so that all decoders get the same
  /// bits.
  double at(std::int64_t q) const noexcept {
    return static_cast<double>(base + q) * static_cast<double>(times) / static_cast<double>(over);
  }
  /// kPoints only: the number of the point nearest to `x`. For writers.
  std::int64_t nearest(double x) const noexcept;
  /// The number of the value 0 or of the point nearest to it; in a list, of the first value whose bits are
  /// all 0, else 0. Not for kFloats [ATTR-59].
  std::int32_t rest() const noexcept;
  /// The bits of the value of `q`, which is 0 to `cells` or a finite float's ordinal.
  std::uint64_t bits_at(ComponentType type, std::int32_t q) const noexcept;
};

constexpr bool is_float(ComponentType type) noexcept {
  return type == ComponentType::kF32 || type == ComponentType::kF64;
}

/// The bits of a component of this type whose number is nearest to `x`, which is finite in the type.
std::uint64_t bits_of_number(ComponentType type, double x) noexcept;

/// The number of a component with these bits.
inline double number_of_bits(ComponentType type, std::uint64_t bits) noexcept {
  return load_component(type, reinterpret_cast<const std::byte*>(&bits));
}

/// Writes the fields. `before`: lattice of the preceding component, or null for the first.
void write_lattice_fields(ByteWriter& out, ComponentType type, const ComponentLattice& lattice,
                          const ComponentLattice* before);

/// Errors: kTruncated, kInvalidStream [ATTR-55].
Result<ComponentLattice> read_lattice_fields(ByteReader& in, ComponentType type,
                                             const ComponentLattice* before);

}  // namespace deltamesh
