// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "entropy/pair_reader.h"

#include <algorithm>

namespace deltamesh {

PairReader::PairReader(const PairBytes& bytes) noexcept
    : begin_(bytes.data()), end_(begin_ + bytes.size()), next_(begin_) {
  bool are_states = true;
  for (std::uint64_t& state : states_) {
    std::uint64_t read = word();
    next_ += 4;
    read |= std::uint64_t{word()} << 32;
    next_ += 4;
    // A state outside its range would make symbols up without end.
    are_states = are_states && next_ <= end_ && read >= kRansFloor && read < kRansFloor << 32;
    if (are_states) state = read;
  }
  if (!are_states) next_ = end_ + 1;
}

Result<void> PairReader::finish(std::uint32_t chunk_tag, std::size_t begin) const noexcept {
  const auto error = [&](ErrorCode code, const char* message) {
    return Error{.code = code,
                 .message = message,
                 .rule = "CMP-3",
                 .where_kind = WhereKind::kByte,
                 .where = begin + static_cast<std::size_t>(std::min(next_, end_) - begin_),
                 .chunk_tag = chunk_tag};
  };
  if (failed()) return error(ErrorCode::kTruncated, "compact bytes end too early");
  if (next_ != end_) return error(ErrorCode::kInvalidStream, "compact bytes left over");
  if (states_[0] != kRansFloor || states_[1] != kRansFloor)
    return error(ErrorCode::kInvalidStream, "compact bytes do not add up");
  return {};
}

}  // namespace deltamesh
