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

/// Codes payloads and collects them; empty payloads are left out.
class ChunkList {
 public:
  ChunkList(Profile profile, int effort)
      : profile_(profile), zstd_level_(effort == 0 ? kQuickZstdLevel : kBestZstdLevel) {}

  /// `compact`: the same payload in the compact form, where it has one.
  Result<void> add(std::uint32_t tag, std::vector<std::byte> payload, std::vector<std::byte> compact = {}) {
    if (payload.empty()) return {};
    if (profile_ == Profile::kZstd) compact.clear();
    DELTAMESH_TRY(auto chunk, code_chunk(tag, std::move(payload), std::move(compact), zstd_level_));
    chunks_.push_back(std::move(chunk));
    return {};
  }
  /// A payload that has a compact form only.
  void add_compact(std::uint32_t tag, std::vector<std::byte> compact) {
    if (compact.empty()) return;
    const std::uint64_t size = compact.size();
    chunks_.push_back(
        {.tag = tag, .codec = ChunkCodec::kCompact, .bytes = std::move(compact), .decoded_bytes = size});
  }
  /// An empty list that codes alike.
  ChunkList fresh() const {
    ChunkList list = *this;
    list.chunks_.clear();
    return list;
  }
  void append(const ChunkList& other) {
    chunks_.insert(chunks_.end(), other.chunks_.begin(), other.chunks_.end());
  }
  const std::vector<CodedChunk>& chunks() const noexcept { return chunks_; }

 private:
  static constexpr int kQuickZstdLevel = 3;

  Profile profile_;
  int zstd_level_;
  std::vector<CodedChunk> chunks_;
};

}  // namespace deltamesh
