// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "paper/paper_rows.h"

#include "base/try.h"
#include "highpass/highpass.h"
#include "measure/measure.h"

namespace deltamesh::bench {
namespace {

// The paper's ratio hardly depends on the bits up to 6; at 8 bits its anchors were coarser relative to delta.
constexpr PaperRow kRows[] = {
    {"armadillo_18245", 4, 150, 6.1}, {"armadillo_18245", 6, 150, 6.1}, {"armadillo_18245", 8, 150, 0},
    {"armadillo_18245", 4, 85, 7.8},  {"armadillo_18245", 6, 85, 7.8},  {"armadillo_18245", 8, 85, 0},
    {"laurana_6301", 4, 52, 6.0},     {"laurana_6301", 6, 52, 6.0},     {"laurana_6301", 8, 52, 0},
    {"laurana_6301", 4, 28, 7.7},     {"laurana_6301", 6, 28, 7.7},     {"laurana_6301", 8, 28, 0},
    {"horse_4243", 4, 38, 6.0},       {"horse_4243", 6, 38, 6.0},       {"horse_4243", 8, 38, 0},
    {"horse_4243", 4, 19, 8.1},       {"horse_4243", 6, 19, 8.1},       {"horse_4243", 8, 19, 0},
};

}  // namespace

std::span<const PaperRow> paper_rows() noexcept { return kRows; }

Result<PaperFigures> measure_paper_row(const WeldedMesh& mesh, const PaperRow& row) {
  AnchorSequence anchors(mesh.graph, mesh.components);
  HighpassCoder coder(mesh.graph, mesh.components, anchors, mesh.positions, mesh.box);
  DELTAMESH_TRY(const CodedHighpass coded,
                coder.code({.step = coder.step_for_bits(row.bits), .anchors = row.anchors}));
  const Quality quality = measure_quality(mesh.graph, mesh.positions, coded.positions);
  return PaperFigures{.vde_over_step = quality.vde_rms / coded.parameters.step,
                      .ratio = quality.lfe_rms / quality.vde_rms};
}

}  // namespace deltamesh::bench
