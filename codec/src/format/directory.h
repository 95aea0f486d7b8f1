// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The chunk directory [DIR-*]: tag, part, codec, lengths and checksum of every chunk, and its place in the
// stream.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/byte_reader.h"
#include "base/byte_writer.h"
#include "deltamesh/result.h"
#include "format/tags.h"

namespace deltamesh {

/// How a chunk's bytes are coded [DIR-4].
enum class ChunkCodec : std::uint8_t { kRaw = 0, kZstd = 1, kCompact = 2 };

inline constexpr std::uint64_t kMaxChunks = 1U << 16;                   // [DIR-1]
inline constexpr std::uint64_t kMaxExpansion = std::uint64_t{1} << 16;  // [DIR-5]

/// True when a reader that does not know the tag may ignore the chunk: fourth letter in lower case [DIR-2].
constexpr bool is_skippable(std::uint32_t tag) noexcept { return (tag >> 29 & 1) != 0; }

struct ChunkEntry {
  std::uint32_t tag = 0;
  std::uint32_t part = 0;
  ChunkCodec codec = ChunkCodec::kRaw;
  std::uint64_t coded_bytes = 0;
  std::uint64_t decoded_bytes = 0;
  std::uint64_t checksum = 0;  ///< xxh3-64 of the coded bytes
  std::uint64_t offset = 0;    ///< first byte in the stream; not stored, follows from the order
};

void write_directory(ByteWriter& out, std::span<const ChunkEntry> entries);

/// Reads the entries and sets every `offset` but checks no bytes of the chunks. Allocates at most in
/// proportion to the bytes present. Errors: kTruncated, kInvalidStream, kUnsupportedFeature [DIR-*].
Result<std::vector<ChunkEntry>> read_directory(ByteReader& in);

}  // namespace deltamesh
