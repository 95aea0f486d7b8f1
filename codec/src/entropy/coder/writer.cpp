// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "entropy/coder/writer.h"

#include <bit>

namespace deltamesh {
namespace {

/// The `count` lowest bytes of `value`, the lowest first.
void put_number(std::vector<std::byte>& bytes, std::uint64_t value, unsigned count) {
  for (unsigned b = 0; b < count; ++b) bytes.push_back(static_cast<std::byte>(value >> (8 * b)));
}

}  // namespace

bool CompactWriter::encode(std::uint64_t begin, States& states, std::size_t& first) {
  // rANS gives symbols back in the opposite order, so the last goes first. A symbol makes a word at most,
  // for which there is room behind those that are still to come.
  states = {begin, begin};
  first = symbols_.size();
  std::size_t turn = symbols_.size() - joined_;
  for (std::size_t i = symbols_.size(); i-- > 0;) {
    const std::size_t own = --turn % 2;
    std::uint64_t& state = states[own];
    const std::uint32_t start = symbols_[i] >> 16;
    const std::uint32_t size = symbols_[i] & 0xffff;
    const bool is_bits = (size & kBitsMark) != 0;
    const std::uint32_t joined =
        i > 0 && (symbols_[i - 1] & kJoinedMark & symbols_[i - 1] >> 1) != 0 ? symbols_[i - 1] : 0;
    const unsigned joined_count = joined & 31;
    const std::uint64_t limit = is_bits ? kRansFloor << 32 >> (size - kBitsMark)
                                        : ((kRansFloor >> kProbabilityBits << 32) * size) >> joined_count;
    if (state >= limit) {
      // A reader takes a word for any state below the floor, as long as there are words.
      if (first == symbols_.size() && states[1 - own] < kRansFloor) return false;
      symbols_[--first] = static_cast<std::uint32_t>(state);
      state >>= 32;
    }
    if (is_bits) {
      state = state << (size - kBitsMark) | start;
      continue;
    }
    state = (state / size << kProbabilityBits) + state % size + start;
    if (joined == 0) continue;
    state = state << joined_count | joined >> 16;
    --i;
  }
  return true;
}

std::vector<std::byte> CompactWriter::finish() {
  States states{};
  std::size_t first = 0;
  if (!encode(kLeastState, states, first)) encode(kRansFloor, states, first);
  const auto size_of = [](std::uint64_t state) {
    return static_cast<unsigned>(std::bit_width(state) + 7) / 8;
  };
  std::vector<std::byte> bytes{static_cast<std::byte>(size_of(states[0]) | size_of(states[1]) << 4)};
  bytes.reserve(17 + 4 * (symbols_.size() - first));
  for (const std::uint64_t state : states) put_number(bytes, state, size_of(state));
  for (std::size_t i = first; i < symbols_.size(); ++i) put_number(bytes, symbols_[i], 4);
  symbols_.clear();
  joined_ = 0;
  return bytes;
}

}  // namespace deltamesh
