// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "entropy/code_chunk.h"

#include <zstd.h>

#include <new>
#include <utility>

#include "base/checked.h"

namespace deltamesh {

CodedChunk code_plain_chunk(std::uint32_t tag, std::vector<std::byte> payload, int zstd_level) {
  CodedChunk chunk{.tag = tag, .codec = ChunkCodec::kZstd, .decoded_bytes = payload.size()};
  chunk.bytes.resize(ZSTD_compressBound(payload.size()));
  const std::size_t size =
      ZSTD_compress(chunk.bytes.data(), chunk.bytes.size(), payload.data(), payload.size(), zstd_level);
  if (ZSTD_isError(size) != 0) throw std::bad_alloc();  // into a buffer of that bound nothing else goes wrong
  if (size >= payload.size() || payload.size() > saturating_mul(size, kMaxExpansion)) {
    chunk.codec = ChunkCodec::kRaw;
    chunk.bytes = std::move(payload);
  } else {
    chunk.bytes.resize(size);
    chunk.bytes.shrink_to_fit();
  }
  return chunk;
}

CodedChunk code_compact_chunk(std::uint32_t tag, std::vector<std::byte> payload) {
  CodedChunk chunk{.tag = tag, .codec = ChunkCodec::kCompact, .decoded_bytes = payload.size()};
  chunk.bytes = std::move(payload);
  return chunk;
}

}  // namespace deltamesh
