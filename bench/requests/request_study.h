// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// How near requests for quality come, what they cost, and how much effort saves; by the public interface.
#pragma once

#include <string>
#include <vector>

#include "deltamesh/encode.h"
#include "deltamesh/mesh.h"
#include "deltamesh/result.h"

namespace deltamesh::bench {

struct NamedRequest {
  std::string name;
  QualityRequest request;
};

struct RequestFigures {
  double vde_load = 0;  ///< achieved over asked; 0 where not asked; so for the next two
  double lfe_load = 0;
  double max_load = 0;
  std::uint64_t bytes = 0;
  double seconds = 0;  ///< processor time of the encoder
};

/// Root mean square over the edges of all triangles.
double edge_length_rms(const Mesh& mesh);

/// VDE at 0.2, 0.05 and 0.01 % of the diagonal and of the edge length; LFE at 0.5, 0.1 and 0.02 % of the
/// diagonal, alone and with a VDE of 0.02 %; a maximum error of 0.5 and 0.05 %.
std::vector<NamedRequest> usual_requests(const Mesh& mesh, double diagonal);

/// Of the bounding box.
double diagonal_of(const Mesh& mesh);

/// Errors: those of encode().
Result<RequestFigures> measure_request(const Mesh& mesh, double diagonal, const EncodeOptions& options);

}  // namespace deltamesh::bench
