// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The data behind the paper's Table 1 and Figures 3, 6 and 7, measured on one mesh.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "deltamesh/result.h"
#include "support/welded_mesh.h"

namespace deltamesh::bench {

/// One coding. Errors: the paper's sums (eqs. 1, 2), mesh scaled to a diagonal of 1.
struct PaperPoint {
  std::string model;
  int bits = 0;
  std::uint32_t anchors = 0;
  std::uint32_t density = 0;  ///< v
  double anchor_share = 0;    ///< of the vertices
  double vde = 0;             ///< S_q
  double lfe = 0;             ///< M_q
};

/// Table 1: 3 to 8 bits, anchors at v = 10.
Result<std::vector<PaperPoint>> study_bits(const std::string& model, const WeldedMesh& mesh);

/// The first of Table 1's figures, were all deltas coded as 0: S_q grows no further, however few the bits.
/// Where the range is set by few large deltas this is near at 3 bits already. Its `bits` are 0.
Result<PaperPoint> study_zeros(const std::string& model, const WeldedMesh& mesh);

/// Figure 3: VDE against the number of anchors, 0.1 to 10 % of the vertices, at 4, 6 and 8 bits.
Result<std::vector<PaperPoint>> study_anchors(const std::string& model, const WeldedMesh& mesh);

/// Figures 6 and 7: LFE, and the share of anchors, against v = 5 .. 15 at 3 to 8 bits.
Result<std::vector<PaperPoint>> study_density(const std::string& model, const WeldedMesh& mesh);

/// One line for each point, with a header line.
std::string points_csv(const std::vector<PaperPoint>& points);

}  // namespace deltamesh::bench
