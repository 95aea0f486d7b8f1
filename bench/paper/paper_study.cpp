// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "paper/paper_study.h"

#include <algorithm>
#include <cstdio>

#include "base/try.h"
#include "format/vertex_positions.h"
#include "highpass/highpass.h"
#include "laplacian/anchors/anchor_sequence.h"
#include "measure/measure.h"

namespace deltamesh::bench {
namespace {

constexpr int kFewestBits = 3;
constexpr int kMostBits = 8;
constexpr std::uint32_t kTableDensity = 10;
constexpr double kShares[] = {0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1};

/// Codes one mesh under the paper's settings: plain rounding, no diffusion, anchors at 12 bits.
class Study {
 public:
  Study(const std::string& model, const WeldedMesh& mesh)
      : model_(model),
        mesh_(mesh),
        anchors_(mesh.graph, mesh.components),
        coder_(mesh.graph, mesh.components, anchors_, mesh.positions, mesh.box) {}

  std::uint32_t count_for_density(std::uint32_t density) {
    return anchors_.count_for_density(mesh_.graph, density);
  }
  std::uint32_t count_for_share(double share) const {
    return static_cast<std::uint32_t>(share * static_cast<double>(mesh_.positions.size()) + 0.5);
  }

  Result<void> add(int bits, std::uint32_t count) { return add(bits, coder_.step_for_bits(bits), count); }
  Result<void> add_zeros(std::uint32_t count) { return add(0, 4 * coder_.range(), count); }

  std::vector<PaperPoint> take() { return std::move(points_); }

 private:
  Result<void> add(int bits, double step, std::uint32_t count) {
    DELTAMESH_TRY(const CodedHighpass coded, coder_.code({.step = step, .anchors = count}));
    DELTAMESH_TRY(const auto positions, to_float_positions(coded.positions));
    const std::size_t vertices = mesh_.positions.size();
    const PaperQuality paper =
        paper_form(measure_quality(mesh_.graph, mesh_.positions, positions), vertices, mesh_.box.diagonal());
    const std::uint32_t anchors = coded.parameters.anchors;
    points_.push_back({.model = model_,
                       .bits = bits,
                       .anchors = anchors,
                       .density = coded.parameters.anchor_density,
                       .anchor_share = static_cast<double>(anchors) / static_cast<double>(vertices),
                       .vde = paper.vde,
                       .lfe = paper.lfe});
    return {};
  }

  std::string model_;
  const WeldedMesh& mesh_;
  AnchorSequence anchors_;
  HighpassCoder coder_;
  std::vector<PaperPoint> points_;
};

}  // namespace

Result<std::vector<PaperPoint>> study_bits(const std::string& model, const WeldedMesh& mesh) {
  Study study(model, mesh);
  for (int bits = kFewestBits; bits <= kMostBits; ++bits)
    DELTAMESH_CHECK(study.add(bits, study.count_for_density(kTableDensity)));
  return study.take();
}

Result<PaperPoint> study_zeros(const std::string& model, const WeldedMesh& mesh) {
  Study study(model, mesh);
  DELTAMESH_CHECK(study.add_zeros(study.count_for_density(kTableDensity)));
  return study.take().front();
}

Result<std::vector<PaperPoint>> study_anchors(const std::string& model, const WeldedMesh& mesh) {
  Study study(model, mesh);
  // The anchors outside, so that a set of them is factored once.
  for (const double share : kShares)
    for (const int bits : {4, 6, 8}) DELTAMESH_CHECK(study.add(bits, study.count_for_share(share)));
  return study.take();
}

Result<std::vector<PaperPoint>> study_density(const std::string& model, const WeldedMesh& mesh) {
  Study study(model, mesh);
  for (std::uint32_t density = 5; density <= 15; ++density)
    for (int bits = kFewestBits; bits <= kMostBits; ++bits)
      DELTAMESH_CHECK(study.add(bits, study.count_for_density(density)));
  return study.take();
}

std::string points_csv(const std::vector<PaperPoint>& points) {
  std::string csv = "model,bits,anchors,v,anchor_share,vde_paper,lfe_paper\n";
  for (const PaperPoint& p : points) {
    char line[160];
    std::snprintf(line, sizeof line, ",%d,%u,%u,%.6g,%.6g,%.6g\n", p.bits, p.anchors, p.density,
                  p.anchor_share, p.vde, p.lfe);
    csv += p.model + line;
  }
  return csv;
}

}  // namespace deltamesh::bench
