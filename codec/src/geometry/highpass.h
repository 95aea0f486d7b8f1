// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// DELT and ANCH: quantised delta coordinates and anchors, reconstructed by least squares (Yang, Li et al.,
// section 3).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/vec3.h"
#include "deltamesh/result.h"
#include "entropy/payload.h"
#include "format/highpass_parameters.h"
#include "topology/adjacency.h"

namespace deltamesh {

/// What the encoder is asked for; exactly one of bits and step, at most one of anchors and density.
struct HighpassRequest {
  std::optional<int> bits{};
  std::optional<double> step{};
  std::optional<std::uint32_t> anchors{};
  std::optional<std::uint32_t> anchor_density{};
  int anchor_bits = 12;
};

struct CodedHighpass {
  HighpassParameters parameters;
  std::vector<std::byte> deltas;           ///< DELT payload, plain
  std::vector<std::byte> compact_deltas;   ///< the same in the compact form
  std::vector<std::byte> anchors;          ///< ANCH payload, plain
  std::vector<std::byte> compact_anchors;  ///< the same in the compact form
  std::vector<Vec3> positions;             ///< n: what read_highpass will return
};

/// `positions`: n, relative to the mesh's origin, in coding order; `graph`, `components`: of the decoded
/// faces, same order; `box`: of `positions`. Errors: kInvalidArgument where the step is too small for 32-bit
/// symbols.
Result<CodedHighpass> write_highpass(const Adjacency& graph, const Components& components,
                                     std::span<const Vec3> positions, const Box& box,
                                     const HighpassRequest& request);

/// Returns n finite positions. Errors: kTruncated, kInvalidStream [DELT-*, ANCH-*, CMP-3, FLD-1].
Result<std::vector<Vec3>> read_highpass(Payload deltas, Payload anchors, const Adjacency& graph,
                                        const Components& components, const Box& box,
                                        const HighpassParameters& parameters);

}  // namespace deltamesh
