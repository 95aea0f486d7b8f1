// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "attributes/lattice/component_lattice.h"

#include <limits>
#include <utility>

#include "attributes/values.h"
#include "base/numbers/zigzag.h"
#include "base/try.h"
#include "positions/floats/order.h"

namespace deltamesh {
namespace {

/// The least and the largest finite number.
std::pair<double, double> range_of(ComponentType type) noexcept {
  return with_component(type, [](auto value) {
    using Limits = std::numeric_limits<decltype(value)>;
    return std::pair(static_cast<double>(Limits::lowest()), static_cast<double>(Limits::max()));
  });
}

bool is_positive(float x) noexcept { return std::isfinite(x) && x > 0; }

}  // namespace

std::uint64_t bits_of_number(ComponentType type, double x) noexcept {
  const auto [least, most] = range_of(type);
  if (type == ComponentType::kF64) return std::bit_cast<std::uint64_t>(x);
  if (type == ComponentType::kF32) {
    const auto cut = static_cast<float>(std::clamp(x, least, most));
    return std::bit_cast<std::uint32_t>(cut);
  }
  const auto whole = static_cast<std::int64_t>(std::clamp(std::floor(x + 0.5), least, most));
  const std::size_t width = 8 * component_size(type);
  return static_cast<std::uint64_t>(whole) & (~std::uint64_t{0} >> (64 - width));
}

std::int32_t ComponentLattice::rest() const noexcept {
  if (kind == LatticeKind::kPoints)
    return static_cast<std::int32_t>(std::clamp(-base, std::int64_t{0}, std::int64_t{cells}));
  const auto clear = std::find(values.begin(), values.end(), 0U);
  return clear == values.end() ? 0 : static_cast<std::int32_t>(clear - values.begin());
}

std::uint64_t ComponentLattice::bits_at(ComponentType type, std::int32_t q) const noexcept {
  switch (kind) {
    case LatticeKind::kConstant:
      return values.front();
    case LatticeKind::kListed:
      return values[static_cast<std::size_t>(q)];
    case LatticeKind::kFloats:
      return std::bit_cast<std::uint32_t>(float_of(q));
    case LatticeKind::kPoints:
      break;
  }
  return bits_of_number(type, at(q));
}

Result<ComponentLattice> read_lattice_fields(ByteReader& in, ComponentType type,
                                             const ComponentLattice* before) {
  const auto invalid = [&](const char* message) { return in.invalid(message, "ATTR-55"); };
  DELTAMESH_TRY(const auto kind, in.read<std::uint8_t>());
  ComponentLattice lattice;
  lattice.kind = static_cast<LatticeKind>(kind);
  if (lattice.is_floats()) {
    DELTAMESH_TRY(lattice.exponent, in.read<std::uint8_t>());
    if (type != ComponentType::kF32 || lattice.exponent == 255)
      return invalid("only finite float32 have ordinals");
    return lattice;
  }
  if (lattice.is_constant() || lattice.kind == LatticeKind::kListed) {
    std::uint64_t count = 1;
    if (!lattice.is_constant()) {
      DELTAMESH_TRY(count, in.read_varint(kMostListed));
      if (count == 0) return invalid("a list without values");
    }
    for (std::uint64_t i = 0; i < count; ++i) {
      DELTAMESH_TRY(const auto bytes, in.read_bytes(component_size(type)));
      lattice.values.push_back(load_component(bytes.data(), bytes.size()));
    }
    lattice.cells = static_cast<std::uint32_t>(count - 1);
    return lattice;
  }
  lattice.kind = LatticeKind::kPoints;
  if (kind == kAsBefore) {
    if (before == nullptr) return invalid("the first component has none before it");
    lattice.times = before->times;
    lattice.over = before->over;
  } else if (kind == kTimes || kind == kRatio) {
    DELTAMESH_TRY(lattice.times, in.read<float>());
    if (kind == kRatio) {
      DELTAMESH_TRY(lattice.over, in.read<float>());
    }
    if (!is_positive(lattice.times) || !is_positive(lattice.over))
      return invalid("a lattice's step is not positive");
  } else {
    return invalid("no such kind of lattice");
  }
  DELTAMESH_TRY(const auto base, in.read_varint(2 * std::uint64_t{kLargestLatticeBase}));
  DELTAMESH_TRY(const auto cells, in.read_varint(kMostLatticeCells));
  lattice.base = unzigzag(base);
  lattice.cells = static_cast<std::uint32_t>(cells);
  const auto [least, most] = range_of(type);
  if (is_float(type) && !(lattice.at(0) >= least && lattice.at(lattice.cells) <= most))
    return invalid("a lattice has points that are not finite");
  return lattice;
}

}  // namespace deltamesh
