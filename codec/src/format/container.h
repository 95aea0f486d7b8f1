// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A whole stream as header, chunks and checksum [CNT-*].
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "deltamesh/result.h"
#include "format/chunk/header.h"
#include "format/header.h"

namespace deltamesh {

/// An error at a chunk's first byte.
Error chunk_error(ErrorCode code, const char* message, const char* rule, const ChunkEntry& entry) noexcept;

/// A stream opened for reading: its checksum and header are checked, its chunks located, nothing is decoded.
class Container {
 public:
  /// `stream` must outlive the container. One pass over its bytes. Errors: 1xx codes.
  static Result<Container> open(std::span<const std::byte> stream);

  const FileHeader& header() const noexcept { return header_; }
  std::span<const ChunkEntry> entries() const noexcept { return entries_; }
  std::size_t size() const noexcept { return stream_.size(); }

  std::span<const std::byte> coded(const ChunkEntry& entry) const noexcept;

  /// The first entry with `tag`, the only one but of attributes and chunks that are skipped; null where there
  /// is none.
  const ChunkEntry* find(std::uint32_t tag) const noexcept;

 private:
  std::span<const std::byte> stream_;
  FileHeader header_;
  std::vector<ChunkEntry> entries_;
};

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
