// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "solver/problem.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "highpass/diffusion.h"
#include "highpass/symbols.h"
#include "laplacian/operator/delta.h"
#include "support/welded_mesh.h"

namespace deltamesh::bench {
namespace {

std::vector<Vec3> quantized_deltas(const Problem& problem) {
  std::vector<Vec3> deltas = delta_coordinates(problem.part.graph, problem.positions);
  const DeltaQuantizer quantizer{.step = problem.settings.step};
  const auto symbols = quantize_deltas(problem.part.graph, deltas, quantizer, problem.settings.diffusion);
  if (!symbols) return deltas;
  for (std::size_t i = 0; i < deltas.size(); ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      deltas[i][axis] = quantizer.value((*symbols)[axis * deltas.size() + i]);
  }
  return deltas;
}

}  // namespace

std::vector<Vec3> Problem::solved_of(std::span<const Vec3> all) const {
  std::vector<Vec3> solved;
  for (std::size_t row = 0; row < part.row_count; ++row)
    solved.push_back(all[part.vertex(row)] - middle(box));
  return solved;
}

Problem make_problem(const MeshView& mesh, const ProblemSettings& settings) {
  WeldedMesh coded = in_coding_order(weld(mesh));
  Problem problem;
  problem.whole = std::move(coded.graph);
  problem.box = coded.box;
  problem.whole_positions = std::move(coded.positions);
  const Components& components = coded.components;
  problem.part = extract_solved_part(problem.whole, components);
  problem.positions = problem.solved_of(problem.whole_positions);

  const auto count = static_cast<std::uint32_t>(0.01 * settings.anchor_percent *
                                                static_cast<double>(problem.part.row_count));
  HighpassSettings& highpass = problem.settings;
  AnchorSequence anchors(problem.whole, components);
  HighpassCoder coder(problem.whole, components, anchors, problem.whole_positions, problem.box);
  highpass.step = coder.step_for_bits(settings.bits);
  highpass.diffusion = settings.diffusion;
  highpass.anchors = count;
  problem.anchors = anchor_rows(coder.anchors_for(highpass).vertices, problem.part);
  problem.deltas = quantized_deltas(problem);
  const AnchorLattice lattice(problem.box, highpass.anchor_bits);
  for (const std::uint32_t anchor : problem.anchors) {
    const Vec3& position = problem.whole_positions[problem.part.vertex(anchor)];
    problem.targets.push_back(lattice.position_of(lattice.cell_of(position)) - middle(problem.box));
  }
  return problem;
}

double rms_difference(std::span<const Vec3> a, std::span<const Vec3> b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += dot(a[i] - b[i], a[i] - b[i]);
  return std::sqrt(sum / static_cast<double>(a.size()));
}

double largest_difference(std::span<const Vec3> a, std::span<const Vec3> b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, length(a[i] - b[i]));
  return largest;
}

}  // namespace deltamesh::bench
