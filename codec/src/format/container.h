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

}  // namespace deltamesh
