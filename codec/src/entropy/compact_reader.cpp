// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "entropy/compact_reader.h"

namespace deltamesh {

CompactReader::CompactReader(std::span<const std::byte> bytes) noexcept : bytes_(bytes) {
  const std::uint64_t low = next_word();
  const std::uint64_t state = std::uint64_t{next_word()} << 32 | low;
  // A state outside its range would make symbols up without end.
  if (state < kRansFloor || state >= kRansFloor << 32) failed_ = true;
  if (!failed_) state_ = state;
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
  if (state_ != kRansFloor) return error(ErrorCode::kInvalidStream, "compact bytes do not add up");
  return {};
}

}  // namespace deltamesh
