// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "entropy/coder/reader.h"

#include <array>
#include <optional>

namespace deltamesh {

namespace {

/// The two states that `bytes` begin with, and where the words begin; nothing where a state is cut or out of
/// its range, so that it would make symbols up without end [CMP-1].
struct Start {
  std::array<std::uint64_t, 2> states{};
  std::size_t size = 1;
};
std::optional<Start> read_start(std::span<const std::byte> bytes) noexcept {
  if (bytes.empty()) return std::nullopt;
  const auto sizes = std::to_integer<unsigned>(bytes[0]);
  const std::array<unsigned, 2> size{sizes & 15, sizes >> 4};
  if (size[0] > 8 || size[1] > 8 || bytes.size() < 1 + size[0] + size[1]) return std::nullopt;
  Start start;
  for (std::size_t k = 0; k < 2; ++k) {
    std::uint64_t& state = start.states[k];
    for (unsigned b = 0; b < size[k]; ++b)
      state |= std::to_integer<std::uint64_t>(bytes[start.size++]) << (8 * b);
    if (state < kLeastState || state >= kRansFloor << 32) return std::nullopt;
  }
  return start;
}

}  // namespace

[[gnu::noinline]] CompactReader::CompactReader(std::span<const std::byte> bytes) noexcept
    : bytes_(bytes), position_(bytes.size()) {
  const auto start = read_start(bytes);
  failed_ = !start;
  if (failed_) return;
  position_ = start->size;
  state_ = start->states[0];
  next_state_ = start->states[1];
}

Result<void> CompactReader::finish(std::uint32_t chunk_tag) const noexcept {
  const auto error = [&](ErrorCode code, const char* message, const char* rule = "CMP-3")
      __attribute__((noinline)) {
    return Error{.code = code,
                 .message = message,
                 .rule = rule,
                 .where_kind = WhereKind::kByte,
                 .where = position_,
                 .chunk_tag = chunk_tag};
  };
  if (failed_ && !read_start(bytes_))
    return error(ErrorCode::kInvalidStream, "compact bytes do not begin with two states", "CMP-1");
  if (failed_) return error(ErrorCode::kTruncated, "bytes end inside a value");
  if (position_ != bytes_.size()) return error(ErrorCode::kInvalidStream, "bytes left over at the end");
  const bool are_equal = state_ == next_state_;
  if (!are_equal || (state_ != kLeastState && state_ != kRansFloor))
    return error(ErrorCode::kInvalidStream, "compact bytes do not add up");
  return {};
}

}  // namespace deltamesh
