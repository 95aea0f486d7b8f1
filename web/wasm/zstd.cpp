// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The exports of `zstd`, for chunks that are coded so.
#include <zstd.h>

#include <cstddef>

#include "runtime.h"

extern "C" {

/// Of the frame at `from`, as ZSTD_findFrameCompressedSize().
DELTAMESH_EXPORT(frameSize) std::size_t frame_size(const void* from, std::size_t bytes) {
  return ZSTD_findFrameCompressedSize(from, bytes);
}

/// As ZSTD_decompress().
DELTAMESH_EXPORT(expand)
std::size_t expand(void* to, std::size_t most, const void* from, std::size_t bytes) {
  return ZSTD_decompress(to, most, from, bytes);
}

}  // extern "C"
