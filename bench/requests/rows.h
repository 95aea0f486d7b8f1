// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What a request takes, what losing nothing takes, and how long decoding takes beside Draco.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "deltamesh/anchor_containers.h"
#include "deltamesh/mesh.h"
#include "deltamesh/quality_request.h"
#include "deltamesh/result.h"

namespace deltamesh::bench {

struct RequestRow {
  std::uint64_t bytes = 0;
  std::uint64_t quick_bytes = 0;   ///< at effort 0
  std::string geometry;            ///< the coder that was chosen
  bool agrees_at_effort_0 = true;  ///< effort 0 chooses the same
  bool kept = true;                ///< the decoded mesh, measured anew, is within the request
};

/// `mesh`: from welded_geometry(). `containers`: of the mesh. Errors: encode()'s, decode()'s.
Result<RequestRow> compare_request(const Mesh& mesh, const QualityRequest& request, int effort,
                                   const std::shared_ptr<AnchorContainers>& containers);

struct LosslessRow {
  double ratio = 0;    ///< bytes over those of zstd -19 on positions and triangles as they lie in memory
  bool exact = false;  ///< positions and faces came back to the last bit, in their order
};
Result<LosslessRow> compare_lossless(const Mesh& mesh);

/// Least processor times of runs in turn, nanoseconds per vertex, of predictive streams with the rms error of
/// Draco's level 7 at 12 bits, beside that stream. Ours are encoded at effort 0.
struct TimeRow {
  double encode_ns = 0;
  double draco_encode_ns = 0;
  double decode_ns = 0;
  double draco_decode_ns = 0;
  double default_encode_ns = 0;     ///< without options
  double vde_encode_ns = 0;         ///< for Draco's VDE, at the default effort
  double slow_draco_encode_ns = 0;  ///< level 10
  double bytes_per_vertex = 0;
  double draco_bytes_per_vertex = 0;
};
Result<TimeRow> compare_times(const Mesh& mesh);

}  // namespace deltamesh::bench
