// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Chunk headers [DIR-*]: kind, codec and lengths.
#pragma once

#include <cstdint>

#include "base/byte_reader.h"
#include "base/byte_writer.h"
#include "deltamesh/result.h"
#include "format/chunk/tags.h"

namespace deltamesh {

/// How a chunk's bytes are coded [DIR-4].
enum class ChunkCodec : std::uint8_t { kRaw = 0, kZstd = 1, kCompact = 2 };

inline constexpr std::uint64_t kMaxChunks = 1U << 16;                   // [DIR-1]
inline constexpr std::uint64_t kMaxExpansion = std::uint64_t{1} << 16;  // [DIR-5]

/// True when a reader that does not know the tag may ignore the chunk: fourth letter in lower case [DIR-2].
constexpr bool is_skippable(std::uint32_t tag) noexcept { return (tag >> 29 & 1) != 0; }

struct ChunkEntry {
  std::uint32_t tag = 0;
  ChunkCodec codec = ChunkCodec::kRaw;
  std::uint64_t coded_bytes = 0;
  std::uint64_t decoded_bytes = 0;
  std::uint64_t offset = 0;  ///< of the coded bytes, in the stream; not stored, follows from the order
};

/// Writes kind and lengths. An attribute's descriptor and the coded bytes follow.
void write_chunk_header(ByteWriter& out, const ChunkEntry& entry);

/// Reads kind and lengths. Errors: kTruncated, kInvalidStream, kUnsupportedFeature [DIR-2, DIR-4, DIR-5].
Result<ChunkEntry> read_chunk_header(ByteReader& in);

}  // namespace deltamesh
