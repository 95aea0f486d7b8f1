// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What `core` uses of zstd: the module `zstd` does it.
#include <zstd.h>

#include <cstddef>

#include "runtime.h"

extern "C" {
/// Of bytes in the memory of `core`.
DELTAMESH_IMPORT(frameSize) std::size_t frame_size_elsewhere(const void* from, std::size_t bytes);
/// From and to the memory of `core`; returns how many bytes came out, or more than `most`.
DELTAMESH_IMPORT(expand)
std::size_t expand_elsewhere(void* to, std::size_t most, const void* from, std::size_t bytes);

std::size_t ZSTD_findFrameCompressedSize(const void* from, std::size_t bytes) {
  return frame_size_elsewhere(from, bytes);
}

std::size_t ZSTD_decompress(void* to, std::size_t most, const void* from, std::size_t bytes) {
  return expand_elsewhere(to, most, from, bytes);
}
}
