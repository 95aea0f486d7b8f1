// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "paper/study.h"

#include "base/try.h"
#include "format/vertex_positions.h"
#include "measure/measure.h"

namespace deltamesh::bench {

PaperStudy::PaperStudy(const WeldedMesh& mesh)
    : mesh_(mesh),
      anchors_(mesh.graph, mesh.components),
      coder_(mesh.graph, mesh.components, anchors_, mesh.positions, mesh.box) {}

Result<PaperPoint> PaperStudy::code(int bits, std::uint32_t anchors) {
  const double step = bits == 0 ? 4 * coder_.range() : coder_.step_for_bits(bits);
  DELTAMESH_TRY(const CodedHighpass coded, coder_.code({.step = step, .anchors = anchors}));
  DELTAMESH_TRY(const auto positions, to_float_positions(coded.positions));
  const std::size_t vertices = mesh_.positions.size();
  const Quality quality = measure_quality(mesh_.graph, mesh_.positions, positions);
  const PaperQuality paper = paper_form(quality, vertices, mesh_.box.diagonal());
  return PaperPoint{
      .bits = bits,
      .anchors = coded.parameters.anchors,
      .density = coded.parameters.anchor_density,
      .anchor_share = static_cast<double>(coded.parameters.anchors) / static_cast<double>(vertices),
      .vde = paper.vde,
      .lfe = paper.lfe,
      .vde_over_step = quality.vde_rms / coded.parameters.step};
}

Result<PaperPoints> PaperStudy::code_all(const std::vector<std::uint32_t>& counts,
                                         std::initializer_list<int> bits) {
  PaperPoints points;
  for (const std::uint32_t count : counts) {
    for (const int each : bits) {
      DELTAMESH_TRY(const PaperPoint point, code(each, count));
      points.push_back(point);
    }
  }
  return points;
}

Result<PaperPoints> PaperStudy::by_bits() {
  return code_all({anchors_.count_for_density(mesh_.graph, 10)}, {0, 3, 4, 5, 6, 7, 8});
}

Result<PaperPoints> PaperStudy::by_anchors() {
  std::vector<std::uint32_t> counts;
  for (const double share : {0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1})
    counts.push_back(static_cast<std::uint32_t>(share * static_cast<double>(mesh_.positions.size()) + 0.5));
  return code_all(counts, {4, 6, 8});
}

Result<PaperPoints> PaperStudy::by_density() {
  std::vector<std::uint32_t> counts;
  for (std::uint32_t density = 5; density <= 15; ++density)
    counts.push_back(anchors_.count_for_density(mesh_.graph, density));
  return code_all(counts, {3, 4, 5, 6, 7, 8});
}

}  // namespace deltamesh::bench
