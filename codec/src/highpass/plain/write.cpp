// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "base/byte_writer.h"
#include "base/numbers/zigzag.h"
#include "entropy/arrays.h"
#include "highpass/plain/plain.h"

namespace deltamesh {

std::vector<std::byte> write_plain_deltas(std::span<const std::int32_t> deltas) {
  std::vector<std::uint32_t> codes;
  codes.reserve(deltas.size());
  for (const std::int32_t delta : deltas) codes.push_back(zigzag(delta));
  ByteWriter out;
  write_array(out, codes);
  return out.take();
}

std::vector<std::byte> write_plain_anchors(std::span<const std::uint32_t> anchors,
                                           std::span<const AnchorCell> cells) {
  ByteWriter out;
  std::vector<std::uint64_t> numbers(anchors.begin(), anchors.end());
  write_differences(out, numbers, 32);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t i = 0; i < cells.size(); ++i) numbers[i] = cells[i][axis];
    write_differences(out, numbers, 32);
  }
  return out.take();
}

}  // namespace deltamesh
