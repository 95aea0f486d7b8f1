// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A chunk's payload to coded bytes and back [ENT-*].
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "deltamesh/result.h"
#include "entropy/payload.h"
#include "format/container.h"

namespace deltamesh {

inline constexpr int kBestZstdLevel = 19;

/// The smallest of raw, one zstd frame and, where it is not empty, the payload's `compact` form.
/// The same payload gives the same bytes for one version of libzstd. Payloads from 64 KiB on whose compact
/// form is below raw are not given to zstd, which would take most of the time and next to never win.
Result<CodedChunk> code_chunk(std::uint32_t tag, std::vector<std::byte> payload,
                              std::vector<std::byte> compact = {}, int zstd_level = kBestZstdLevel);

/// A payload with its bytes, as far as these are not the container's.
struct ExpandedChunk {
  std::vector<std::byte> expanded{};
  std::span<const std::byte> stored{};  ///< where nothing had to be expanded
  bool is_compact = false;

  std::span<const std::byte> bytes() const noexcept { return expanded.empty() ? stored : expanded; }
  Payload payload() const noexcept { return is_compact ? Payload::compact(bytes()) : Payload(bytes()); }
};

/// Expands a chunk of `container`, which must outlive it, into a buffer of exactly entry.decoded_bytes, which
/// may be at most `max_bytes`; raw and compact bytes stay where they are. Errors: kInvalidStream
/// [DIR-5, ENT-1].
Result<ExpandedChunk> expand_chunk(const Container& container, const ChunkEntry& entry,
                                   std::uint64_t max_bytes);

/// The same for the only chunk with `tag`; empty where there is none [DIR-8].
Result<ExpandedChunk> expand_single(const Container& container, std::uint32_t tag, std::uint64_t max_bytes);

}  // namespace deltamesh
