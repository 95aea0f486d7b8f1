// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "decoder/read_grid_chunks.h"

#include "base/try.h"
#include "entropy/expand_chunk.h"

namespace deltamesh {

Result<GridMesh> read_grid_chunks(const Container& container, const Learning<GridModels>& learning) {
  std::array<ExpandedChunk, kGridTags.size()> expanded;
  GridChunks chunks;
  for (std::size_t k = 0; k < chunks.size(); ++k) {
    DELTAMESH_TRY(expanded[k], expand_single(container, kGridTags[k]));
    chunks[k] = expanded[k].bytes();
  }
  const FileHeader& header = container.header();
  return read_grid(chunks, header.predictive, header.geometric_vertices, header.triangles, learning);
}

}  // namespace deltamesh
