// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "entropy/expand_chunk.h"

#include "base/checked.h"
#include "base/try.h"
#include "entropy/zstd_frame.h"

namespace deltamesh {

Result<ExpandedChunk> expand_chunk(const Container& container, const ChunkEntry& entry) {
  const auto coded = container.coded(entry);
  if (entry.codec != ChunkCodec::kZstd)
    return ExpandedChunk{.stored = coded, .is_compact = entry.codec == ChunkCodec::kCompact};
  // The buffer is sized by the chunk's checked header, never by what the frame says of itself.
  std::vector<std::byte> bytes(memory_size(entry.decoded_bytes));
  if (!expand_frame(coded, bytes))
    return chunk_error(ErrorCode::kInvalidStream, "not one zstd frame of the decoded length", "ENT-1", entry);
  return ExpandedChunk{.expanded = std::move(bytes)};
}

Result<ExpandedChunk> expand_single(const Container& container, std::uint32_t tag) {
  const ChunkEntry* const entry = container.find(tag);
  if (entry == nullptr) return ExpandedChunk{};
  return expand_chunk(container, *entry);
}

}  // namespace deltamesh
