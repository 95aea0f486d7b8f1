// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "entropy/compact_writer.h"

#include "base/byte_writer.h"
#include "entropy/compact_reader.h"

namespace deltamesh {

std::vector<std::byte> CompactWriter::finish() {
  // rANS gives symbols back in the opposite order, so the last goes first.
  std::uint64_t state = kRansFloor;
  std::vector<std::uint32_t> words;
  for (std::size_t i = intervals_.size(); i-- > 0;) {
    const std::uint32_t start = intervals_[i] >> 16;
    const std::uint32_t size = intervals_[i] & 0xffff;
    if (state >= (kRansFloor >> kProbabilityBits << 32) * size) {
      words.push_back(static_cast<std::uint32_t>(state));
      state >>= 32;
    }
    state = ((state / size) << kProbabilityBits) + state % size + start;
  }
  intervals_.clear();

  ByteWriter out;
  out.write(state);
  for (std::size_t i = words.size(); i-- > 0;) out.write(words[i]);
  return out.take();
}

}  // namespace deltamesh
