// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "entropy/code_chunk.h"

#include <zstd.h>

#include <utility>

#include "base/checked.h"
#include "base/try.h"

namespace deltamesh {
namespace {

/// Payloads of this size and up that have a compact form below raw are not tried with zstd.
constexpr std::size_t kTryEverything = 1U << 16;

Result<CodedChunk> code_plain(std::uint32_t tag, std::vector<std::byte> payload, int zstd_level) {
  CodedChunk chunk{.tag = tag, .codec = ChunkCodec::kZstd, .decoded_bytes = payload.size()};
  chunk.bytes.resize(ZSTD_compressBound(payload.size()));
  const std::size_t size =
      ZSTD_compress(chunk.bytes.data(), chunk.bytes.size(), payload.data(), payload.size(), zstd_level);
  if (ZSTD_isError(size) != 0)
    return Error{.code = ErrorCode::kOutOfMemory, .message = "zstd cannot compress"};
  if (size >= payload.size() || payload.size() > saturating_mul(size, kMaxExpansion)) {
    chunk.codec = ChunkCodec::kRaw;
    chunk.bytes = std::move(payload);
  } else {
    chunk.bytes.resize(size);
    chunk.bytes.shrink_to_fit();
  }
  return chunk;
}

}  // namespace

Result<CodedChunk> code_chunk(std::uint32_t tag, std::vector<std::byte> payload,
                              std::vector<std::byte> compact, int zstd_level) {
  CodedChunk chunk{.tag = tag, .codec = ChunkCodec::kCompact, .decoded_bytes = compact.size()};
  if (!compact.empty() && payload.size() >= kTryEverything && compact.size() < payload.size()) {
    chunk.bytes = std::move(compact);
    return chunk;
  }
  DELTAMESH_TRY(CodedChunk plain, code_plain(tag, std::move(payload), zstd_level));
  if (compact.empty() || plain.bytes.size() <= compact.size()) return plain;
  chunk.bytes = std::move(compact);
  return chunk;
}

}  // namespace deltamesh
