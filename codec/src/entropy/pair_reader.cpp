// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "entropy/pair_reader.h"

namespace deltamesh {
namespace {

/// Two states, if they are all.
constexpr std::size_t kFewestBytes = 16;
constexpr std::array<std::byte, kFewestBytes> kNothing{};

}  // namespace

PairReader::PairReader(std::span<const std::byte> bytes) noexcept
    : bytes_(bytes.size() < kFewestBytes ? std::span<const std::byte>(kNothing) : bytes),
      last_word_(bytes_.size() - 4) {
  bool are_states = bytes.size() >= kFewestBytes;
  for (std::uint64_t& state : states_) {
    const std::uint64_t low = word_at(position_);
    const std::uint64_t read = std::uint64_t{word_at(position_ + 4)} << 32 | low;
    position_ += 8;
    // A state outside its range would make symbols up without end.
    are_states = are_states && read >= kRansFloor && read < kRansFloor << 32;
    if (are_states) state = read;
  }
  if (!are_states) position_ = bytes_.size() + 1;
}

Result<void> PairReader::finish(std::uint32_t chunk_tag, std::size_t begin) const noexcept {
  const auto error = [&](ErrorCode code, const char* message) {
    return Error{.code = code,
                 .message = message,
                 .rule = "CMP-3",
                 .where_kind = WhereKind::kByte,
                 .where = begin + std::min(position_, bytes_.size()),
                 .chunk_tag = chunk_tag};
  };
  if (failed()) return error(ErrorCode::kTruncated, "compact bytes end too early");
  if (position_ != bytes_.size()) return error(ErrorCode::kInvalidStream, "compact bytes left over");
  if (states_[0] != kRansFloor || states_[1] != kRansFloor)
    return error(ErrorCode::kInvalidStream, "compact bytes do not add up");
  return {};
}

}  // namespace deltamesh
