// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The fields of an attribute on lattices: which components they take, and which values they make
// [ATTR-56].
#pragma once

#include <bit>
#include <span>
#include <vector>

#include "attributes/copies.h"
#include "attributes/field_faces.h"
#include "attributes/lattice/component_lattice.h"
#include "attributes/values.h"
#include "positions/blend/blend.h"

namespace deltamesh {

/// Components, three at a time, that are not constant, and either all floats or none.
using FieldGroup = std::vector<std::size_t>;

inline std::vector<FieldGroup> field_groups(std::span<const ComponentLattice> lattices) {
  std::vector<FieldGroup> groups;
  for (std::size_t c = 0; c < lattices.size(); ++c) {
    if (lattices[c].is_constant()) continue;
    if (groups.empty() || groups.back().size() == 3 ||
        lattices[groups.back().front()].is_floats() != lattices[c].is_floats())
      groups.emplace_back();
    groups.back().push_back(c);
  }
  return groups;
}

/// Puts the values of a group's numbers, or of the constant components, into rows.
class LatticeValues {
 public:
  LatticeValues(ComponentType type, std::span<const ComponentLattice> lattices, std::size_t count)
      : type_(type), lattices_(lattices), values_(type, lattices.size(), count) {
    for (std::size_t c = 0; c < lattices.size(); ++c)
      if (lattices[c].is_constant())
        values_.set_component(c, [&](std::size_t) { return lattices[c].values.front(); });
  }

  void set_group(const FieldGroup& group, std::span<const Cell> cells) noexcept {
    for (std::size_t axis = 0; axis < group.size(); ++axis) {
      const ComponentLattice& lattice = lattices_[group[axis]];
      if (type_ == ComponentType::kF32 && lattice.kind == LatticeKind::kPoints) {
        set_points(group[axis], axis, cells);
      } else {
        values_.set_component(group[axis],
                              [&](std::size_t i) { return lattice.bits_at(type_, cells[i][axis]); });
      }
    }
  }

  std::vector<std::byte> take() noexcept { return values_.take(); }

 private:
  /// Floats that are points, finite as the lattice's ends are, without a choice of kind for each of them. Of
  /// morph targets most are zero, as all bits are at first.
  void set_points(std::size_t component, std::size_t axis, std::span<const Cell> cells) noexcept {
    const ComponentLattice& lattice = lattices_[component];
    const std::int32_t rest = lattice.rest();
    const bool rest_is_zero = lattice.bits_at(type_, rest) == 0;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const std::int32_t q = cells[i][axis];
      if (rest_is_zero && q == rest) continue;
      values_.set(i, component, std::bit_cast<std::uint32_t>(static_cast<float>(lattice.at(q))));
    }
  }

  ComponentType type_;
  std::span<const ComponentLattice> lattices_;
  AttributeValues values_;
};

}  // namespace deltamesh
