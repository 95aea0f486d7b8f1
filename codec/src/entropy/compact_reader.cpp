// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "entropy/compact_reader.h"

namespace deltamesh {

CompactReader::CompactReader(std::span<const std::byte> bytes) noexcept : bytes_(bytes) {
  const auto read_state = [this] {
    const std::uint64_t low = next_word();
    return std::uint64_t{next_word()} << 32 | low;
  };
  const std::uint64_t first = read_state();
  const std::uint64_t second = read_state();
  // A state outside its range would make symbols up without end.
  const auto is_state = [](std::uint64_t state) { return state >= kRansFloor && state < kRansFloor << 32; };
  if (!is_state(first) || !is_state(second)) failed_ = true;
  if (failed_) return;
  state_ = first;
  next_state_ = second;
}

Result<void> CompactReader::finish(std::uint32_t chunk_tag) const noexcept {
  const auto error = [&](ErrorCode code, const char* message) {
    return Error{.code = code,
                 .message = message,
                 .rule = "CMP-3",
                 .where_kind = WhereKind::kByte,
                 .where = position_,
                 .chunk_tag = chunk_tag};
  };
  if (failed_) return error(ErrorCode::kTruncated, "compact bytes end too early");
  if (position_ != bytes_.size()) return error(ErrorCode::kInvalidStream, "compact bytes left over");
  if (state_ != kRansFloor || next_state_ != kRansFloor)
    return error(ErrorCode::kInvalidStream, "compact bytes do not add up");
  return {};
}

}  // namespace deltamesh
