// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Which manifold vertices are one vertex of the mesh: gaps and targets of the glued ones [CONN-11].
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "deltamesh/result.h"
#include "entropy/compact_reader.h"
#include "entropy/compact_writer.h"

namespace deltamesh {

/// What a stream says of the glued vertices, one of each per glued vertex.
struct GlueList {
  std::vector<std::uint32_t> gaps;     ///< new vertices since the glued one before
  std::vector<std::uint32_t> targets;  ///< zigzag of the difference to the target before
};

/// Vertex of every manifold vertex. Errors: kInvalidStream [CONN-11].
Result<std::vector<std::uint32_t>> glue_vertices(const GlueList& list, std::uint32_t manifold_count,
                                                 std::uint32_t vertex_count);

/// Checks a list's length before anything of its size is allocated. Errors: kInvalidStream [CONN-11].
Result<void> check_glue_count(std::uint64_t count, std::uint32_t manifold_count, std::uint32_t vertex_count);

/// The list by the compact coder: its length, then gap and target of each [CONN-13].
void write_compact_gluing(CompactWriter& writer, const GlueList& list);

/// Errors: kInvalidStream [CONN-11]. Stops early where the reader failed.
Result<GlueList> read_compact_gluing(CompactReader& reader, std::uint32_t manifold_count,
                                     std::uint32_t vertex_count);

}  // namespace deltamesh
