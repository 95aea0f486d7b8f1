// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A chunk's payload from coded bytes [ENT-*].
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "deltamesh/result.h"
#include "entropy/payload.h"
#include "format/container.h"

namespace deltamesh {

/// A payload with its bytes, as far as these are not the container's.
struct ExpandedChunk {
  std::vector<std::byte> expanded{};
  std::span<const std::byte> stored{};  ///< where nothing had to be expanded
  bool is_compact = false;

  std::span<const std::byte> bytes() const noexcept { return expanded.empty() ? stored : expanded; }
  Payload payload() const noexcept { return is_compact ? Payload::compact(bytes()) : Payload(bytes()); }
};

/// Expands a chunk of `container`, which must outlive it, into a buffer of exactly entry.decoded_bytes; raw
/// and compact bytes stay where they are. Errors: kInvalidStream [ENT-1].
Result<ExpandedChunk> expand_chunk(const Container& container, const ChunkEntry& entry);

/// The same for the only chunk with `tag`; empty where there is none [DIR-8].
Result<ExpandedChunk> expand_single(const Container& container, std::uint32_t tag);

}  // namespace deltamesh
