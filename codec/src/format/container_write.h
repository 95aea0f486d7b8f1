// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Writes a whole stream: header, chunks and checksum [CNT-*].
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "format/chunk_header.h"
#include "format/header.h"

namespace deltamesh {

/// A chunk ready to be stored.
struct CodedChunk {
  std::uint32_t tag = 0;
  ChunkCodec codec = ChunkCodec::kRaw;
  std::vector<std::byte> bytes{};  ///< coded
  std::uint64_t decoded_bytes = 0;
};

/// Header, chunks and checksum. ATTR chunks take the header's descriptors in order; default ones where there
/// are none. A mesh so regular that its stream would break [CNT-5] is given a filler chunk.
std::vector<std::byte> write_container(const FileHeader& header, std::span<const CodedChunk> chunks);

/// The size of what write_container() returns, without writing it.
std::uint64_t container_bytes(const FileHeader& header, std::span<const CodedChunk> chunks);

}  // namespace deltamesh
