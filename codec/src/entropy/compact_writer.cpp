// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "entropy/compact_writer.h"

#include "base/byte_writer.h"

namespace deltamesh {

std::vector<std::byte> CompactWriter::finish() {
  // rANS gives symbols back in the opposite order, so the last goes first.
  std::uint64_t state = kRansFloor;
  std::vector<std::uint32_t> words;
  const auto make_room = [&](std::uint64_t limit) {
    if (state < limit) return;
    words.push_back(static_cast<std::uint32_t>(state));
    state >>= 32;
  };
  for (std::size_t i = decisions_.size(); i-- > 0;) {
    const std::uint32_t start = decisions_[i] >> 16;
    const std::uint32_t size = decisions_[i] & 0xffff;
    if ((size & kBitsMark) != 0) {
      const std::uint32_t count = size - kBitsMark;
      make_room(kRansFloor << 32 >> count);
      state = state << count | start;
    } else {
      make_room((kRansFloor >> kProbabilityBits << 32) * size);
      state = ((state / size) << kProbabilityBits) + state % size + start;
    }
  }
  decisions_.clear();

  ByteWriter out;
  out.write(state);
  for (std::size_t i = words.size(); i-- > 0;) out.write(words[i]);
  return out.take();
}

}  // namespace deltamesh
