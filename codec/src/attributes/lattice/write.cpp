// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>
#include <unordered_map>

#include "attributes/lattice/fit.h"
#include "attributes/lattice/group.h"
#include "attributes/lattice/lattice.h"
#include "entropy/coder/writer.h"
#include "positions/blend/fit.h"
#include "positions/floats/order.h"
#include "positions/guess_trial.h"

namespace deltamesh {
namespace {

/// Fields where so much rests may be sparse: one vertex in so many.
constexpr std::size_t kSparseValues = 8;

/// The numbers of a lattice, not of kConstant, for the values it was fitted to.
class LatticeNumbers {
 public:
  LatticeNumbers(const ComponentLattice& lattice, ComponentType type) : lattice_(lattice), type_(type) {
    for (const std::uint64_t value : lattice.values)
      places_.emplace(value, static_cast<std::int32_t>(places_.size()));
  }

  /// What stands for the value with these bits.
  std::int32_t of(std::uint64_t bits) const {
    if (lattice_.is_floats()) return ordinal_of(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
    if (lattice_.kind == LatticeKind::kListed) return places_.at(bits);
    return static_cast<std::int32_t>(lattice_.nearest(number_of_bits(type_, bits)));
  }

 private:
  const ComponentLattice& lattice_;
  ComponentType type_;
  std::unordered_map<std::uint64_t, std::int32_t> places_;  ///< in a list
};

std::vector<Cell> cells_of(const FieldGroup& group, std::span<const ComponentLattice> lattices,
                           ComponentType type, const AttributeRows& rows) {
  std::vector<Cell> cells(rows.count(), Cell{});
  for (std::size_t axis = 0; axis < group.size(); ++axis) {
    const LatticeNumbers numbers(lattices[group[axis]], type);
    std::uint64_t last = 0;
    rows.for_each(group[axis], [&](std::size_t row, std::uint64_t bits) {
      cells[row][axis] = row > 0 && bits == last ? cells[row - 1][axis] : numbers.of(bits);
      last = bits;
    });
  }
  return cells;
}

void write_ordinals(CompactWriter& writer, const FieldFaces& over, const std::array<int, 3>& units,
                    std::span<Ordinals> ordinals) {
  std::vector<Cell> cells = over.first_copies(std::span<const Ordinals>(ordinals));
  for (Cell& cell : cells)
    for (std::size_t axis = 0; axis < cell.size(); ++axis) cell[axis] = fixed_of(cell[axis], units[axis]);
  code_ordinals(writer, over, units, fit_blends(over.faces(), cells, BlendFit::kSquares), ordinals);
}

/// Returns `form`, but without run lengths of resting rows if that takes fewer bytes.
GroupForm smaller_form(const FieldFaces& over, const GroupForm& form, std::span<Cell> cells) {
  const auto size_of = [&](GroupForm candidate) {
    CompactWriter trial;
    code_numbers(trial, over, candidate, cells);
    return trial.finish().size();
  };
  GroupForm dense = form;
  dense.sparse = false;
  return size_of(form) <= size_of(dense) ? form : dense;
}

void write_numbers(CompactWriter& writer, const FieldFaces& over, GroupForm form, int effort,
                   std::span<Cell> cells) {
  const std::vector<Cell> shared = over.first_copies(std::span<const Cell>(cells));
  const auto resting = static_cast<std::size_t>(std::count(shared.begin(), shared.end(), form.rest));
  form.sparse = kSparseValues * resting >= shared.size();
  form.guesses = true;
  if (2 * resting < shared.size()) {  // else the rest is too little to fit a table to
    form.blends = fit_blends(over.faces(), shared, effort > 0 ? BlendFit::kSquares : BlendFit::kSample);
    form.guesses = guesses_pay(over.faces(), shared, form.most, form.blends);
  }
  if (form.sparse && effort > 0) form = smaller_form(over, form, cells);
  code_numbers(writer, over, form, cells);
}

}  // namespace

std::optional<CodedValues<std::byte>> write_lattice(const AttributeView& attribute, const AttributeRows& rows,
                                                    double bound, int effort,
                                                    const AttributeSurface& surface) {
  const auto lattices = fit_lattices(attribute, rows, bound);
  if (!lattices) return std::nullopt;
  ByteWriter out;
  for (std::size_t c = 0; c < lattices->size(); ++c)
    write_lattice_fields(out, attribute.type, (*lattices)[c], c > 0 ? &(*lattices)[c - 1] : nullptr);

  const auto groups = field_groups(*lattices);
  LatticeValues values(attribute.type, *lattices, rows.count());
  if (!groups.empty()) {
    std::vector<std::vector<Cell>> cells;
    cells.reserve(groups.size());
    for (const FieldGroup& group : groups) cells.push_back(cells_of(group, *lattices, attribute.type, rows));
    const bool joined = std::all_of(cells.begin(), cells.end(), [&](const std::vector<Cell>& group) {
      return copies_agree(surface.geometric(), std::span<const Cell>(group));
    });
    const FieldFaces over(surface, joined);
    CompactWriter writer;
    writer.bits(joined ? 1 : 0, 1);
    for (std::size_t g = 0; g < groups.size(); ++g) {
      if ((*lattices)[groups[g].front()].is_floats()) {
        write_ordinals(writer, over, float_units(groups[g], *lattices), cells[g]);
      } else {
        write_numbers(writer, over, form_of(groups[g], *lattices), effort, cells[g]);
      }
      values.set_group(groups[g], cells[g]);
    }
    out.write_bytes(writer.finish());
  }
  return CodedValues<std::byte>{.bytes = out.take(), .values = values.take()};
}

}  // namespace deltamesh
