// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <bit>

#include "entropy/planes.h"

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

}  // namespace deltamesh
