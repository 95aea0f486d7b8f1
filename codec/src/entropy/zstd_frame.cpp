// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "entropy/zstd_frame.h"

#include <zstd.h>

namespace deltamesh {

bool expand_frame(std::span<const std::byte> frame, std::span<std::byte> expanded) noexcept {
  return ZSTD_findFrameCompressedSize(frame.data(), frame.size()) == frame.size() &&
         ZSTD_decompress(expanded.data(), expanded.size(), frame.data(), frame.size()) == expanded.size();
}

}  // namespace deltamesh
