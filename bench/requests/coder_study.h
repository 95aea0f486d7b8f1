// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What error diffusion and frugal symbols bring, each beside plain quantisation on the same footing; and
// what kept anchors save.
#pragma once

#include <cstdint>

#include "deltamesh/result.h"
#include "deltamesh/stream_info.h"
#include "support/welded_mesh.h"

namespace deltamesh::bench {

struct CodedFigures {
  Quality quality;
  std::uint64_t bytes = 0;  ///< of deltas and anchors, compact
};

struct Comparison {
  CodedFigures plain;
  CodedFigures other;
};

/// Anchors: one for 500 vertices, 16 bits, in both. `mesh`: in coding order. Plain quantisation at `bits`;
/// the other one with diffusion at a step that takes as many bytes, within 0.1 %. Errors: those of
/// HighpassCoder.
Result<Comparison> compare_diffusion(const WeldedMesh& mesh, int bits, double strength);

/// Plain quantisation, at centroids, at `bits`; the other one with symbols chosen by price too
/// (FrugalSymbols), at a step that gives the same VDE, within 0.1 %.
Result<Comparison> compare_frugal(const WeldedMesh& mesh, int bits, double rate_weight);

/// Processor seconds.
struct ContainerFigures {
  double first = 0;   ///< of finding the containers 15 to 5
  double second = 0;  ///< of taking them again, fingerprint included
};
ContainerFigures time_containers(const WeldedMesh& mesh);

}  // namespace deltamesh::bench
