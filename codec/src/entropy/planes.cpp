// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "entropy/planes.h"

#include <algorithm>
#include <bit>

namespace deltamesh {

void write_planes(ByteWriter& out, std::span<const std::uint32_t> symbols) {
  std::uint32_t all = 0;
  for (const std::uint32_t symbol : symbols) all |= symbol;
  const unsigned planes = (static_cast<unsigned>(std::bit_width(all)) + 7) / 8;
  out.write(static_cast<std::uint8_t>(planes));
  for (unsigned plane = 0; plane < planes; ++plane) {
    for (const std::uint32_t symbol : symbols) out.write(static_cast<std::uint8_t>(symbol >> (8 * plane)));
  }
}

Result<std::vector<std::uint32_t>> read_planes(ByteReader& in, std::uint64_t count) {
  DELTAMESH_TRY(const auto planes, in.read<std::uint8_t>());
  if (planes > 4) return in.error(ErrorCode::kInvalidStream, "more than four byte planes", "CON-5");
  if (planes != 0 && count > in.remaining() / planes)
    return in.error(ErrorCode::kTruncated, "bytes end inside the byte planes", "CON-5");
  std::vector<std::uint32_t> symbols(static_cast<std::size_t>(count));
  for (unsigned plane = 0; plane < planes; ++plane) {
    DELTAMESH_TRY(const auto bytes, in.read_bytes(count));
    for (std::size_t i = 0; i < bytes.size(); ++i)
      symbols[i] |= std::to_integer<std::uint32_t>(bytes[i]) << (8 * plane);
  }
  return symbols;
}

}  // namespace deltamesh
