// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The chunks of a stream in the making.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "deltamesh/encode.h"
#include "entropy/code_chunk.h"
#include "format/chunk/tags.h"

namespace deltamesh {

/// Codes payloads as a profile and an effort ask, collects them and counts their bytes.
class ChunkList {
 public:
  ChunkList() = default;
  ChunkList(Profile profile, int effort) noexcept
      : profile_(profile), zstd_level_(kZstdLevels[static_cast<std::size_t>(effort)]) {}

  /// `payload`: in the form of the profile; if it is empty, there is no chunk.
  void add(std::uint32_t tag, std::vector<std::byte> payload) {
    if (payload.empty()) return;
    append(is_plain() ? code_plain_chunk(tag, std::move(payload), zstd_level_)
                      : code_compact_chunk(tag, std::move(payload)));
  }
  /// Whatever the profile: `payload` as it is, or under zstd.
  void add_plain(std::uint32_t tag, std::vector<std::byte> payload) {
    if (!payload.empty()) append(code_plain_chunk(tag, std::move(payload), zstd_level_));
  }
  /// The smaller of both forms of an attribute, of which one may be empty.
  void add_attribute(std::vector<std::byte> compact, std::vector<std::byte> plain,
                     const AttributeDescriptor& attribute) {
    CodedChunk chunk;
    if (!plain.empty()) chunk = code_plain_chunk(kTagAttribute, std::move(plain), zstd_level_);
    if (chunk.bytes.empty() || (!compact.empty() && compact.size() < chunk.bytes.size()))
      chunk = code_compact_chunk(kTagAttribute, std::move(compact));
    chunk.attribute = attribute;
    append(std::move(chunk));
  }
  void append(ChunkList other) {
    bytes_ += other.bytes_;
    for (CodedChunk& chunk : other.chunks_) chunks_.push_back(std::move(chunk));
  }

  const std::vector<CodedChunk>& chunks() const noexcept { return chunks_; }
  /// Whether payloads are to be in the plain form.
  bool is_plain() const noexcept { return profile_ == Profile::kZstd; }
  /// Size of the chunks in the stream, bytes, with their headers.
  std::uint64_t bytes() const noexcept { return bytes_; }

 private:
  void append(CodedChunk chunk) {
    bytes_ += stored_bytes(chunk);
    chunks_.push_back(std::move(chunk));
  }

  /// By effort. The last takes a twentieth off the bytes of the one before, in four times its time.
  static constexpr std::array<int, 3> kZstdLevels{3, 12, kBestZstdLevel};

  Profile profile_ = Profile::kSmallest;
  int zstd_level_ = kZstdLevels[1];
  std::vector<CodedChunk> chunks_;
  std::uint64_t bytes_ = 0;
};

}  // namespace deltamesh
