// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// One mesh, coded under the paper's settings: plain rounding, no diffusion, anchors at 12 bits.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <vector>

#include "deltamesh/result.h"
#include "highpass/highpass.h"
#include "laplacian/anchors/anchor_sequence.h"
#include "support/welded_mesh.h"

namespace deltamesh::bench {

/// One coding.
struct PaperPoint {
  int bits = 0;
  std::uint32_t anchors = 0;
  std::uint32_t density = 0;  ///< v
  double anchor_share = 0;    ///< of the vertices
  double vde = 0;             ///< S_q: the paper's sums (eqs. 1, 2), mesh scaled to a diagonal of 1
  double lfe = 0;             ///< M_q, likewise
  double vde_over_step = 0;   ///< S_q as a root mean square / (range of delta * 2^-bits)
};
using PaperPoints = std::vector<PaperPoint>;

class PaperStudy {
 public:
  /// `mesh` outlives the study.
  explicit PaperStudy(const WeldedMesh& mesh);

  /// `bits` 0: all deltas coded as 0. S_q grows no further than that, however few the bits; where the range
  /// is set by few large deltas this is near at 3 bits already. Errors: those of HighpassCoder.
  Result<PaperPoint> code(int bits, std::uint32_t anchors);

  /// Table 1: at v = 10, without deltas and with 3 to 8 bits.
  Result<PaperPoints> by_bits();
  /// Figure 3: 0.1 to 10 % of the vertices as anchors, at 4, 6 and 8 bits.
  Result<PaperPoints> by_anchors();
  /// Figures 6 and 7: v = 5 .. 15 at 3 to 8 bits.
  Result<PaperPoints> by_density();

 private:
  Result<PaperPoints> code_all(const std::vector<std::uint32_t>& counts, std::initializer_list<int> bits);

  const WeldedMesh& mesh_;
  AnchorSequence anchors_;
  HighpassCoder coder_;
};

}  // namespace deltamesh::bench
