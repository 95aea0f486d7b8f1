// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The chunks of a stream in the making.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/try.h"
#include "deltamesh/encode.h"
#include "entropy/code_chunk.h"

namespace deltamesh {

/// Codes payloads as a profile and an effort ask, collects them and counts their bytes.
class ChunkList {
 public:
  ChunkList() = default;
  ChunkList(Profile profile, int effort) noexcept
      : profile_(profile), zstd_level_(effort == 0 ? kQuickZstdLevel : kBestZstdLevel) {}

  /// `compact`: the same payload in the compact form, where it has one. An empty payload has this form only;
  /// if both are empty, there is no chunk. `attribute`: of ATTR.
  Result<void> add(std::uint32_t tag, std::vector<std::byte> payload, std::vector<std::byte> compact,
                   AttributeDescriptor attribute = {}) {
    if (payload.empty()) {
      add_compact(tag, std::move(compact), std::move(attribute));
      return {};
    }
    if (profile_ == Profile::kZstd) compact.clear();
    DELTAMESH_TRY(CodedChunk chunk, code_chunk(tag, std::move(payload), std::move(compact), zstd_level_));
    chunk.attribute = std::move(attribute);
    append(std::move(chunk));
    return {};
  }
  /// A payload that has the compact form only.
  void add_compact(std::uint32_t tag, std::vector<std::byte> compact, AttributeDescriptor attribute = {}) {
    if (compact.empty()) return;
    const std::uint64_t size = compact.size();
    append(CodedChunk{.tag = tag,
                      .codec = ChunkCodec::kCompact,
                      .bytes = std::move(compact),
                      .decoded_bytes = size,
                      .attribute = std::move(attribute)});
  }
  void append(ChunkList other) {
    bytes_ += other.bytes_;
    for (CodedChunk& chunk : other.chunks_) chunks_.push_back(std::move(chunk));
  }

  const std::vector<CodedChunk>& chunks() const noexcept { return chunks_; }
  /// Size of the chunks in the stream, bytes, with their headers.
  std::uint64_t bytes() const noexcept { return bytes_; }

 private:
  void append(CodedChunk chunk) {
    bytes_ += stored_bytes(chunk);
    chunks_.push_back(std::move(chunk));
  }

  static constexpr int kQuickZstdLevel = 3;

  Profile profile_ = Profile::kSmallest;
  int zstd_level_ = kBestZstdLevel;
  std::vector<CodedChunk> chunks_;
  std::uint64_t bytes_ = 0;
};

}  // namespace deltamesh
