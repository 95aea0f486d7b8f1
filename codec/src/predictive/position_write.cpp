// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "entropy/compact_writer.h"
#include "predictive/blend_fit.h"
#include "predictive/float_coder.h"
#include "predictive/lattice_coder.h"
#include "predictive/positions.h"
#include "predictive/voxel_coder.h"

namespace deltamesh {
namespace {

/// `values` in the order of a walk; an empty order leaves them.
template <class T>
std::vector<T> in_order(std::span<const T> values, const std::vector<std::uint32_t>& order) {
  if (order.empty()) return {values.begin(), values.end()};
  std::vector<T> result;
  result.reserve(order.size());
  for (const std::uint32_t vertex : order) result.push_back(values[vertex]);
  return result;
}

std::vector<std::byte> write_cells(const FaceStars& stars, std::vector<Cell> cells,
                                   const PredictiveParameters& parameters, const PositionForm& form) {
  CompactWriter writer;
  Walk walk = form.walk;
  code_walk(writer, walk);
  BlendTable blends = fit_blends(stars, cells, form.fit);
  code_blends(writer, blends);
  const auto write_with = [&](auto coder) {
    for (std::uint32_t v = 0; v < cells.size(); ++v) coder.code_vertex(v, cells);
    return writer.finish();
  };
  const PositionLattice& lattice = parameters.lattice;
  if (parameters.kind == PositionKind::kVoxel)
    return write_with(VoxelCoder(writer, stars, lattice.cells, parameters.levels, blends));
  writer.bits(form.guesses ? 1 : 0, 1);
  return write_with(LatticeCoder(writer, stars, lattice.cells, blends, form.guesses));
}

std::vector<std::byte> write_ordinals(const FaceStars& stars, std::vector<Ordinals> floats,
                                      const std::array<int, 3>& units, const PositionForm& form) {
  std::vector<Cell> cells(floats.size());
  for (std::size_t v = 0; v < floats.size(); ++v)
    for (std::size_t axis = 0; axis < 3; ++axis) cells[v][axis] = fixed_of(floats[v][axis], units[axis]);
  CompactWriter writer;
  Walk walk = form.walk;
  code_walk(writer, walk);
  BlendTable blends = fit_blends(stars, cells, form.fit);
  code_blends(writer, blends);
  FloatCoder coder(writer, stars, units, blends);
  for (std::uint32_t v = 0; v < floats.size(); ++v) coder.code_vertex(v, floats);
  return writer.finish();
}

}  // namespace

std::vector<std::byte> write_positions(const FaceStars& stars, std::span<const Cell> cells,
                                       const PredictiveParameters& parameters, const PositionForm& form) {
  if (cells.empty()) return {};
  const auto order = walk_order(stars, form.walk);
  if (order.empty()) return write_cells(stars, in_order(cells, order), parameters, form);
  return write_cells(renumber(stars, order), in_order(cells, order), parameters, form);
}

std::vector<std::byte> write_floats(const FaceStars& stars, std::span<const Vec3> positions, const Box& box,
                                    const PositionForm& form) {
  if (positions.empty()) return {};
  std::vector<Ordinals> floats(positions.size());
  for (std::size_t v = 0; v < floats.size(); ++v)
    for (std::size_t axis = 0; axis < 3; ++axis)
      floats[v][axis] = ordinal_of(static_cast<float>(positions[v][axis]));
  const auto order = walk_order(stars, form.walk);
  auto ordered = in_order(std::span<const Ordinals>(floats), order);
  if (order.empty()) return write_ordinals(stars, std::move(ordered), float_units(box), form);
  return write_ordinals(renumber(stars, order), std::move(ordered), float_units(box), form);
}

}  // namespace deltamesh
