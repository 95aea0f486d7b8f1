// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "peers/zstd_frame.h"

#include <zstd.h>

#include <string>

#include "peers/peer.h"
#include "support/errors.h"

namespace deltamesh::bench {

Result<std::vector<std::byte>> zstd_frame(std::span<const std::byte> raw) {
  std::vector<std::byte> frame(ZSTD_compressBound(raw.size()));
  const std::size_t size = ZSTD_compress(frame.data(), frame.size(), raw.data(), raw.size(), kZstdLevel);
  if (ZSTD_isError(size) != 0U) return failure("zstd cannot compress");
  frame.resize(size);
  return frame;
}

Result<std::vector<std::byte>> open_zstd_frame(std::span<const std::byte> frame) {
  std::vector<std::byte> raw(ZSTD_getFrameContentSize(frame.data(), frame.size()));
  if (ZSTD_isError(ZSTD_decompress(raw.data(), raw.size(), frame.data(), frame.size())) != 0U)
    return failure("zstd cannot decompress what it compressed");
  return raw;
}

std::string zstd_version() { return ZSTD_versionString(); }

}  // namespace deltamesh::bench
