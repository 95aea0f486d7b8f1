// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "solver/problem.h"

#include <algorithm>
#include <cmath>

#include "connectivity/connectivity.h"
#include "geometry/diffusion.h"
#include "laplacian/anchors.h"
#include "laplacian/delta.h"
#include "support/welded_mesh.h"

namespace deltamesh::bench {
namespace {

constexpr double kLastAnchorCell = 4095;

Vec3 round_to(const Vec3& v, double step) {
  if (!(step > 0)) return v;
  return {step * std::round(v[0] / step), step * std::round(v[1] / step), step * std::round(v[2] / step)};
}

std::vector<Vec3> quantized_deltas(const Adjacency& graph, const std::vector<Vec3>& positions,
                                   const ProblemSettings& settings) {
  std::vector<Vec3> deltas = delta_coordinates(graph, positions);
  const double step = std::ldexp(delta_range(deltas), -settings.bits);
  if (!(step > 0)) return deltas;
  const DeltaQuantizer quantizer{.step = step};
  const auto symbols = quantize_deltas(graph, deltas, quantizer, settings.diffusion);
  if (!symbols) return deltas;
  for (std::size_t i = 0; i < deltas.size(); ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      deltas[i][axis] = quantizer.value((*symbols)[axis * deltas.size() + i]);
  }
  return deltas;
}

}  // namespace

Problem make_problem(const MeshView& mesh, const ProblemSettings& settings) {
  const WeldedMesh welded = weld(mesh);
  const auto vertex_count = static_cast<std::uint32_t>(welded.positions.size());
  const CodedConnectivity coded = write_connectivity(welded.triangles, vertex_count);
  const Adjacency graph = build_adjacency(coded.triangles, vertex_count);
  Problem problem{extract_solved_part(graph, find_components(graph)), {}, {}, {}, {}};
  const Vec3 center = 0.5 * (welded.box.min + welded.box.max);
  for (std::size_t row = 0; row < problem.part.row_count; ++row)
    problem.positions.push_back(welded.positions[coded.vertex_order[problem.part.vertex(row)]] - center);
  const Adjacency& solved = problem.part.graph;
  const auto count =
      static_cast<std::uint32_t>(0.01 * settings.anchor_percent * static_cast<double>(solved.vertex_count()));
  problem.anchors = place_anchors(solved, find_components(solved), {.count = count}).vertices;
  problem.deltas = quantized_deltas(solved, problem.positions, settings);
  const double cell = welded.box.longest_side() / kLastAnchorCell;
  for (const std::uint32_t anchor : problem.anchors)
    problem.targets.push_back(round_to(problem.positions[anchor], cell));
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
