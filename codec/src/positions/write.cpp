// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>

#include "entropy/coder/writer.h"
#include "positions/blend/fit.h"
#include "positions/floats/coder.h"
#include "positions/guess_trial.h"
#include "positions/lattice/coder.h"
#include "positions/positions.h"

namespace deltamesh {
namespace {

/// `values` in coding order; an empty order leaves them.
template <class T>
std::vector<T> in_order(std::span<const T> values, const std::vector<std::uint32_t>& order) {
  if (order.empty()) return {values.begin(), values.end()};
  std::vector<T> result;
  result.reserve(order.size());
  for (const std::uint32_t vertex : order) result.push_back(values[vertex]);
  return result;
}

/// The replacements with vertices numbered by their place in `order`.
std::vector<Replacement> in_order(std::span<const Replacement> replacements,
                                  const std::vector<std::uint32_t>& order) {
  std::vector<Replacement> result(replacements.begin(), replacements.end());
  if (order.empty() || replacements.empty()) return result;
  std::vector<std::uint32_t> place(order.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) place[order[i]] = i;
  for (Replacement& replacement : result) {
    const auto vertex = static_cast<std::size_t>(replacement.coordinate / 3);
    replacement.coordinate = 3 * std::uint64_t{place[vertex]} + replacement.coordinate % 3;
  }
  std::sort(result.begin(), result.end(),
            [](const Replacement& a, const Replacement& b) { return a.coordinate < b.coordinate; });
  return result;
}

std::vector<std::byte> write_cells(const KnownFaces& faces, std::vector<Cell> cells,
                                   const PredictiveParameters& parameters, const PositionForm& form,
                                   std::vector<Replacement> replacements, const LatticeModels* start) {
  CompactWriter writer;
  writer.reserve(9 * std::size_t{faces.vertex_count()});
  CodingOrder coding_order = form.coding_order;
  code_coding_order(writer, coding_order);
  BlendTable blends = fit_blends(faces, cells, form.fit);
  code_blends(writer, blends);
  const PositionLattice& lattice = parameters.lattice;
  const bool guesses = form.guesses == Guessing::kPrediction
                           ? guesses_pay(faces, cells, lattice.cells, blends)
                           : form.guesses == Guessing::kAlways;
  writer.bits(guesses ? 1 : 0, 1);
  writer.bits(replacements.empty() ? 0 : 1, 1);
  LatticeCoder coder(writer, faces, lattice.cells, blends, guesses, start);
  for (std::uint32_t v = 0; v < cells.size();) coder.code_next(v, cells);
  if (!replacements.empty()) code_replacements(writer, replacements, 3 * cells.size());
  return writer.finish();
}

std::vector<std::byte> write_ordinals(const KnownFaces& faces, std::vector<Ordinals> floats,
                                      const std::array<int, 3>& units, const PositionForm& form) {
  std::vector<Cell> cells(floats.size());
  for (std::size_t v = 0; v < floats.size(); ++v)
    for (std::size_t axis = 0; axis < 3; ++axis) cells[v][axis] = fixed_of(floats[v][axis], units[axis]);
  CompactWriter writer;
  writer.reserve(9 * std::size_t{faces.vertex_count()});
  CodingOrder coding_order = form.coding_order;
  code_coding_order(writer, coding_order);
  BlendTable blends = fit_blends(faces, cells, form.fit);
  code_blends(writer, blends);
  FloatCoder coder(writer, faces, units, blends);
  for (std::uint32_t v = 0; v < floats.size(); ++v) coder.code_vertex(v, floats);
  return writer.finish();
}

}  // namespace

std::vector<std::byte> write_positions(const FaceList& faces, std::span<const Cell> cells,
                                       const PredictiveParameters& parameters, const PositionForm& form,
                                       std::span<const Replacement> replacements,
                                       const LatticeModels* start) {
  if (cells.empty()) return {};
  std::vector<std::uint32_t> order;
  const KnownFaces known = known_in_order(faces, form.coding_order, order);
  return write_cells(known, in_order(cells, order), parameters, form, in_order(replacements, order), start);
}

std::vector<std::byte> write_floats(const FaceList& faces, std::span<const Vec3> positions, const Box& box,
                                    const PositionForm& form) {
  if (positions.empty()) return {};
  std::vector<Ordinals> floats(positions.size());
  for (std::size_t v = 0; v < floats.size(); ++v)
    for (std::size_t axis = 0; axis < 3; ++axis)
      floats[v][axis] = ordinal_of(static_cast<float>(positions[v][axis]));
  std::vector<std::uint32_t> order;
  const KnownFaces known = known_in_order(faces, form.coding_order, order);
  return write_ordinals(known, in_order(std::span<const Ordinals>(floats), order), float_units(box), form);
}

}  // namespace deltamesh
