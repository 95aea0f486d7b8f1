// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "entropy/chunk_codec.h"

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

Result<ExpandedChunk> expand_chunk(const Container& container, const ChunkEntry& entry,
                                   std::uint64_t max_bytes) {
  if (entry.decoded_bytes > max_bytes)
    return chunk_error(ErrorCode::kInvalidStream, "the chunk is longer than the header's counts allow",
                       "DIR-5", entry);
  const auto coded = container.coded(entry);
  if (entry.codec != ChunkCodec::kZstd)
    return ExpandedChunk{.stored = coded, .is_compact = entry.codec == ChunkCodec::kCompact};
  // The buffer is sized by our own checked directory, never by what the frame says of itself.
  std::vector<std::byte> bytes(static_cast<std::size_t>(entry.decoded_bytes));
  const bool one_frame = ZSTD_findFrameCompressedSize(coded.data(), coded.size()) == coded.size();
  if (!one_frame || ZSTD_decompress(bytes.data(), bytes.size(), coded.data(), coded.size()) != bytes.size())
    return chunk_error(ErrorCode::kInvalidStream, "not one zstd frame of the length in the directory",
                       "ENT-1", entry);
  return ExpandedChunk{.expanded = std::move(bytes)};
}

Result<ExpandedChunk> expand_single(const Container& container, std::uint32_t tag, std::uint64_t max_bytes) {
  DELTAMESH_TRY(const auto* entry, container.find(tag));
  if (entry == nullptr) return ExpandedChunk{};
  return expand_chunk(container, *entry, max_bytes);
}

}  // namespace deltamesh
