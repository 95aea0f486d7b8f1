// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A coded topology as chunks.
#pragma once

#include <cstdint>

#include "deltamesh/encode.h"
#include "encoder/coded_topology.h"
#include "entropy/chunk_list.h"

namespace deltamesh {

struct TopologyChunks {
  ChunkList faces;   ///< CONN; empty where the geometry has the faces
  ChunkList splits;  ///< seams and groups
  ChunkList order;   ///< the input's, if it is kept; plain payloads are in that order

  /// Of all but the faces.
  std::uint64_t other_bytes() const noexcept { return splits.bytes() + order.bytes(); }
};

/// `topology`: of `mesh`. O(n + m).
TopologyChunks code_topology_chunks(const MeshView& mesh, const EncodeOptions& options,
                                    const CodedTopology& topology);

}  // namespace deltamesh
