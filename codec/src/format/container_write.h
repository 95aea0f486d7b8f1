// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Writes a whole stream: header, chunks and checksum [CNT-*].
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "format/chunk/header.h"
#include "format/header.h"

namespace deltamesh {

/// A chunk ready to be stored.
struct CodedChunk {
  std::uint32_t tag = 0;
  ChunkCodec codec = ChunkCodec::kRaw;
  std::vector<std::byte> bytes{};  ///< coded
  std::uint64_t decoded_bytes = 0;
  AttributeDescriptor attribute{};  ///< of an ATTR chunk
};

/// Header, chunks and checksum. A mesh so regular that its stream would break [CNT-5] is given a filler
/// chunk.
std::vector<std::byte> write_container(const FileHeader& header, std::span<const CodedChunk> chunks);

/// Size of a chunk in a stream, bytes, with its header.
std::uint64_t stored_bytes(const CodedChunk& chunk);

/// The size of a stream whose chunks take `chunk_bytes`, as write_container() makes it.
std::uint64_t stream_bytes(const FileHeader& header, std::uint64_t chunk_bytes);

}  // namespace deltamesh
