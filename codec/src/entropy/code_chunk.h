// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A chunk's payload to coded bytes [ENT-*].
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "deltamesh/result.h"
#include "format/container_write.h"

namespace deltamesh {

inline constexpr int kBestZstdLevel = 19;

/// The smallest of raw, one zstd frame and, where it is not empty, the payload's `compact` form.
/// The same payload gives the same bytes for one version of libzstd. Payloads from 64 KiB on whose compact
/// form is below raw are not given to zstd, which would take most of the time and next to never win.
Result<CodedChunk> code_chunk(std::uint32_t tag, std::vector<std::byte> payload,
                              std::vector<std::byte> compact = {}, int zstd_level = kBestZstdLevel);

}  // namespace deltamesh
