// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The rows of the paper's Table 2 that are reproduced.
#pragma once

#include <cstdint>

namespace deltamesh::bench {

struct PaperRow {
  const char* model;  ///< file under CORPUS/paper, without suffix
  int bits;
  std::uint32_t anchors;
  double paper_ratio;  ///< M_q / S_q as printed in the paper, with one decimal; 0 where not compared
};

/// Grouped by model. The paper's ratio hardly depends on the bits up to 6; at 8 bits its anchors were coarser
/// relative to delta.
inline constexpr PaperRow kPaperRows[] = {
    {"armadillo_18245", 4, 150, 6.1}, {"armadillo_18245", 6, 150, 6.1}, {"armadillo_18245", 8, 150, 0},
    {"armadillo_18245", 4, 85, 7.8},  {"armadillo_18245", 6, 85, 7.8},  {"armadillo_18245", 8, 85, 0},
    {"laurana_6301", 4, 52, 6.0},     {"laurana_6301", 6, 52, 6.0},     {"laurana_6301", 8, 52, 0},
    {"laurana_6301", 4, 28, 7.7},     {"laurana_6301", 6, 28, 7.7},     {"laurana_6301", 8, 28, 0},
    {"horse_4243", 4, 38, 6.0},       {"horse_4243", 6, 38, 6.0},       {"horse_4243", 8, 38, 0},
    {"horse_4243", 4, 19, 8.1},       {"horse_4243", 6, 19, 8.1},       {"horse_4243", 8, 19, 0},
};

}  // namespace deltamesh::bench
