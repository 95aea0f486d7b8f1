// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The rows of the paper's Table 2 that are reproduced: model, bits and anchors, and its M_q / S_q.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "deltamesh/result.h"
#include "support/welded_mesh.h"

namespace deltamesh::bench {

struct PaperRow {
  const char* model;  ///< file under CORPUS/paper, without suffix
  int bits;
  std::uint32_t anchors;
  double paper_ratio;  ///< M_q / S_q as printed in the paper, with one decimal; 0 where not compared
};

struct PaperFigures {
  double vde_over_step = 0;  ///< S_q (rms) / (range of delta * 2^-bits)
  double ratio = 0;          ///< M_q / S_q
};

/// All rows, grouped by model.
std::span<const PaperRow> paper_rows() noexcept;

/// Codes `mesh` as the row says and measures it. Errors: those of HighpassCoder.
Result<PaperFigures> measure_paper_row(const WeldedMesh& mesh, const PaperRow& row);

}  // namespace deltamesh::bench
