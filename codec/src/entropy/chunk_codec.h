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
#include "format/container.h"

namespace deltamesh {

/// The smaller of raw and one zstd frame (level 19). The same payload gives the same bytes for one version of
/// libzstd.
Result<CodedChunk> code_chunk(std::uint32_t tag, std::vector<std::byte> payload);

/// Expands a chunk of `container` into a buffer of exactly entry.decoded_bytes, which may be at most
/// `max_bytes`. Errors: kCorrupt [DIR-6], kInvalidStream [DIR-5, ENT-1].
Result<std::vector<std::byte>> expand_chunk(const Container& container, const ChunkEntry& entry,
                                            std::uint64_t max_bytes);

/// The same for the only chunk with `tag`; empty where there is none [DIR-8].
Result<std::vector<std::byte>> expand_single(const Container& container, std::uint32_t tag,
                                             std::uint64_t max_bytes);

}  // namespace deltamesh
