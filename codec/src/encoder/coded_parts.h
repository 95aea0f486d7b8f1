// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Geometry and attributes, which share the stream's bytes and its request.
#pragma once

#include <cstdint>

#include "base/progress.h"
#include "deltamesh/encode.h"
#include "deltamesh/result.h"
#include "encoder/coded_topology.h"
#include "search/candidate.h"

namespace deltamesh {

struct PartsTask {
  const EncodeOptions& options;
  const MeshView& mesh;
  const CodedTopology& topology;
  const SourceGeometry& source;
  const FileHeader& header;   ///< but for what depends on the geometry
  std::uint64_t chunk_bytes;  ///< of all other chunks
  Progress& progress;
};

struct CodedParts {
  Candidate geometry;
  ChunkList attributes;
};

/// The smallest that keeps the request, or the best that fits the bytes asked for. Errors: kUnmetRequest,
/// kInvalidMesh.
Result<CodedParts> code_parts(const PartsTask& task);

}  // namespace deltamesh
