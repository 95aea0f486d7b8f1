// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Geometry and attributes, which share the stream's bytes and its request.
#pragma once

#include <cstdint>
#include <optional>

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
  const TopologyChunks& topology_chunks;  ///< of `topology`
  const SourceGeometry& source;
  const FileHeader& header;   ///< but for what depends on the geometry
  std::uint64_t other_bytes;  ///< of all other chunks
  Progress& progress;
};

/// Of a geometry that has the faces, and brings them into an order of its own.
struct GridTopology {
  CodedTopology topology;
  TopologyChunks chunks;
};

struct CodedParts {
  Candidate geometry;
  ChunkList attributes;
  std::optional<GridTopology> in_grid;  ///< in place of the task's
};

/// The smallest that keeps the request, or the best that fits the bytes asked for. Errors: kUnmetRequest,
/// kInvalidMesh.
Result<CodedParts> code_parts(const PartsTask& task);

}  // namespace deltamesh
