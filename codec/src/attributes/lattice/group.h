// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The fields of an attribute on lattices [ATTR-56]: which components make one, the values that its numbers
// stand for, and the coding of the numbers by one of three predictors, in one template for both directions.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "attributes/copies.h"
#include "attributes/field_faces.h"
#include "attributes/lattice/component_lattice.h"
#include "attributes/values.h"
#include "entropy/coder/number_model.h"
#include "positions/blend/blend.h"
#include "positions/floats/coder.h"
#include "positions/lattice/coder.h"
#include "positions/surroundings.h"

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

/// `Coder` is CompactWriter or CompactReader.
template <class Coder>
class RestingRuns {
 public:
  RestingRuns(Coder& coder, const KnownFaces& faces, const Cell& rest)
      : coder_(coder), faces_(faces), rest_(rest), moves_(faces.vertex_count(), 0) {}

  /// How many of `rows` rest from `row` on, the first copy of `vertex`, so that no more is coded of them; any
  /// number where a stream lies. A reader's rows are not looked at.
  std::uint32_t code(std::uint32_t row, std::uint32_t vertex, std::span<const Cell> rows) {
    if (row == end_ || moves_around(vertex)) return 0;
    std::uint32_t length = 0;
    if constexpr (Coder::kWrites)
      while (row + length < rows.size() && rows[row + length] == rest_) ++length;
    length = coder_.number(length, lengths_);
    end_ = row + length;
    return length;
  }

  /// Called after a vertex that is in no run was coded.
  void end(std::uint32_t vertex, const Cell& cell) noexcept { moves_[vertex] = cell != rest_ ? 1 : 0; }

 private:
  bool moves_around(std::uint32_t vertex) const noexcept {
    const NearCorners near = faces_.near(vertex);
    if (near.known_count == 0) return vertex > 0 && moves_[vertex - 1] != 0;
    const std::size_t last = near.known_count - 1;
    return (moves_[near.a[0]] | moves_[near.b[0]] | moves_[near.a[last]] | moves_[near.b[last]]) != 0;
  }

  Coder& coder_;
  const KnownFaces& faces_;
  Cell rest_;
  std::uint32_t end_ = kNoVertex;    ///< the row after the last run, which does not begin another
  std::vector<std::uint8_t> moves_;  ///< 1 or 0
  NumberModel lengths_;
};

/// How the numbers of a group are coded.
struct GroupForm {
  unsigned axes = 3;                    ///< 1 to 3; the other numbers are 0
  std::array<std::uint32_t, 3> most{};  ///< numbers are 0 to this, which is at most 2^28
  BlendTable blends = kUsualBlends;
  bool guesses = false;  ///< numbers are compared with those around first
  bool sparse = false;   ///< what is at rest is told in runs [ATTR-59]
  Cell rest{};           ///< the numbers there
};

/// Properties of the group's components, without a writer's choices.
inline GroupForm form_of(const FieldGroup& group, std::span<const ComponentLattice> lattices) {
  GroupForm form;
  form.axes = static_cast<unsigned>(group.size());
  for (std::size_t axis = 0; axis < group.size(); ++axis) {
    form.most[axis] = lattices[group[axis]].cells;
    form.rest[axis] = lattices[group[axis]].rest();
  }
  return form;
}

inline bool is_within(const Cell& cell, const GroupForm& form) noexcept {
  bool within = true;
  for (std::size_t axis = 0; axis < cell.size(); ++axis)
    within = within && cell[axis] >= 0 && static_cast<std::uint32_t>(cell[axis]) <= form.most[axis];
  return within;
}

/// Codes `cells`, one for every vertex; a reader, which has them at rest, fills them in. False where a number
/// is beyond its lattice, or, in a reader, the bytes end.
template <class Coder>
bool code_numbers(Coder& coder, const FieldFaces& over, GroupForm& form, std::span<Cell> cells) {
  CopyCoder<Coder, 3> copies(coder, form.axes);
  const auto code_copy = [&](const Cell& before, Cell& cell) {
    copies.code(before, cell);
    return is_within(cell, form);
  };
  code_blends(coder, form.blends);
  form.guesses = coder.bits(form.guesses ? 1 : 0, 1) != 0;
  form.sparse = coder.bits(form.sparse ? 1 : 0, 1) != 0;
  LatticeCoder<Coder> field(coder, over.faces(), form.most, form.blends, form.guesses);
  std::optional<RestingRuns<Coder>> runs;
  if (form.sparse) {
    field.clear_history();
    runs.emplace(coder, over.faces(), form.rest);
  }
  return code_with_copies(
      coder, over.geometric(), over.vertex_count(), cells,
      [&](std::uint32_t vertex, std::span<Cell> all) {
        if (!field.code_vertex(vertex, form.axes, all)) return false;
        if (runs) runs->end(vertex, all[vertex]);
        return true;
      },
      code_copy, form.rest,
      [&](std::uint32_t row, std::uint32_t vertex) { return runs ? runs->code(row, vertex, cells) : 0; });
}

/// The same of the ordinals of floats, whose largest have these exponents.
template <class Coder>
bool code_ordinals(Coder& coder, const FieldFaces& over, const std::array<int, 3>& units, BlendTable blends,
                   std::span<Ordinals> ordinals) {
  code_blends(coder, blends);
  FloatCoder<Coder> field(coder, over.faces(), units, blends);
  CopyCoder<Coder, 3> copies(coder, 3);
  return code_with_copies(
      coder, over.geometric(), over.vertex_count(), ordinals,
      [&](std::uint32_t vertex, std::span<Ordinals> all) {
        return field.code_vertex(vertex, all) == nullptr;
      },
      [&](const Ordinals& before, Ordinals& row) {
        copies.code(before, row);
        return std::all_of(row.begin(), row.end(), is_finite_ordinal);
      });
}

/// Units of the fixed numbers that a group's floats are predicted as [FLT-2].
inline std::array<int, 3> float_units(const FieldGroup& group, std::span<const ComponentLattice> lattices) {
  std::array<int, 3> units{};
  for (std::size_t axis = 0; axis < units.size(); ++axis) {
    const std::uint32_t exponent = axis < group.size() ? lattices[group[axis]].exponent : 0;
    units[axis] = last_place(exponent << 23) - 3;
  }
  return units;
}

}  // namespace deltamesh
