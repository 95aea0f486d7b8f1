// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A chunk's payload to coded bytes [ENT-*].
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "format/container.h"

namespace deltamesh {

inline constexpr int kBestZstdLevel = 19;

/// Of a payload in the plain form: the smaller of raw and one zstd frame. The same payload gives the same
/// bytes for one version of libzstd. Throws std::bad_alloc.
CodedChunk code_plain_chunk(std::uint32_t tag, std::vector<std::byte> payload,
                            int zstd_level = kBestZstdLevel);

/// Of a payload in the compact form, which is coded already.
CodedChunk code_compact_chunk(std::uint32_t tag, std::vector<std::byte> payload);

}  // namespace deltamesh
