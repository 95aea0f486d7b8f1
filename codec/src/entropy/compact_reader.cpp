// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "entropy/compact_reader.h"

#include <array>

namespace deltamesh {

CompactReader::CompactReader(std::span<const std::byte> bytes) noexcept : bytes_(bytes) {
  const auto sizes = bytes.empty() ? 0 : std::to_integer<unsigned>(bytes[0]);
  const std::array<unsigned, 2> size{sizes & 15, sizes >> 4};
  std::array<std::uint64_t, 2> states{};
  position_ = 1;
  // A state outside its range would make symbols up without end.
  failed_ = size[0] > 8 || size[1] > 8 || bytes.size() < 1 + size[0] + size[1];
  for (std::size_t k = 0; k < 2 && !failed_; ++k) {
    for (unsigned b = 0; b < size[k]; ++b)
      states[k] |= std::to_integer<std::uint64_t>(bytes[position_++]) << (8 * b);
    failed_ = states[k] < kLeastState || states[k] >= kRansFloor << 32;
  }
  if (failed_) {
    position_ = bytes.size();
    return;
  }
  state_ = states[0];
  next_state_ = states[1];
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
  const bool are_equal = state_ == next_state_;
  if (!are_equal || (state_ != kLeastState && state_ != kRansFloor))
    return error(ErrorCode::kInvalidStream, "compact bytes do not add up");
  return {};
}

}  // namespace deltamesh
