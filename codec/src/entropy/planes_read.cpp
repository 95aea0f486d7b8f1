// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "base/checked.h"
#include "entropy/planes.h"

namespace deltamesh {

Result<std::vector<std::uint32_t>> read_planes(ByteReader& in, std::uint64_t count) {
  DELTAMESH_TRY(const auto planes, in.read<std::uint8_t>());
  if (planes > 4) return in.invalid("more than four byte planes", "CON-5");
  if (planes != 0 && count > in.remaining() / planes)
    return in.error(ErrorCode::kTruncated, "bytes end inside the byte planes", "CON-1");
  std::vector<std::uint32_t> symbols(memory_size(count));
  for (unsigned plane = 0; plane < planes; ++plane) {
    DELTAMESH_TRY(const auto bytes, in.read_bytes(count));
    for (std::size_t i = 0; i < bytes.size(); ++i)
      symbols[i] |= std::to_integer<std::uint32_t>(bytes[i]) << (8 * plane);
  }
  return symbols;
}

}  // namespace deltamesh
