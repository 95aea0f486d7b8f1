// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Border ops as bytes: a run of new vertices and the op that closes it are one token [CONN-9].
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "connectivity/faces/border_item.h"
#include "connectivity/faces/gate.h"

namespace deltamesh {

/// A token is the closing op times 32 plus the number of new vertices before it, 0 to 30; or kLongRun.
inline constexpr std::uint32_t kLongestRun = 31;
inline constexpr std::uint32_t kLongRun = kLongestRun;  ///< 31 new vertices, and the run goes on
inline constexpr std::uint32_t kFacesPerToken = 32;     ///< no stream has more, starts included

/// Tokens are kept apart by what is known where their run begins; the last stream is for loops of three,
/// which mostly end at once.
inline constexpr std::size_t kTokenStreams = 17;
constexpr std::size_t token_stream(const Gate& gate) noexcept {
  if (gate.loop == 2 && gate.focus_faces > 1 && !gate.other_side_closed) return 16;
  return std::min<std::uint32_t>(gate.focus_faces, 7) + (gate.other_side_closed ? 8 : 0);
}

/// Sink of ops on the writer's side.
class TokenWriter {
 public:
  void put(BorderOp op, const Gate& gate) {
    if (run_ == 0) stream_ = token_stream(gate);
    if (op != BorderOp::kNewVertex) {
      put_token(static_cast<std::uint32_t>(op) * 32 + run_);
    } else if (++run_ == kLongestRun) {
      put_token(kLongRun);
    }
  }
  const std::vector<std::byte>& stream(std::size_t i) const noexcept { return streams_[i]; }

 private:
  void put_token(std::uint32_t token) {
    streams_[stream_].push_back(static_cast<std::byte>(token));
    run_ = 0;
  }

  std::array<std::vector<std::byte>, kTokenStreams> streams_;
  std::size_t stream_ = 0;
  std::uint32_t run_ = 0;
};

/// Source of ops on the reader's side.
class TokenReader {
 public:
  explicit TokenReader(const std::array<std::span<const std::byte>, kTokenStreams>& streams) noexcept
      : streams_(streams) {}

  /// None when the stream is at its end or the token is none.
  BorderOp get(const Gate& gate) noexcept {
    if (run_ == 0 && closing_ == BorderOp::kNewVertex && !get_token(streams_[token_stream(gate)]))
      return BorderOp::kNone;
    if (run_ > 0) {
      --run_;
      return BorderOp::kNewVertex;
    }
    return std::exchange(closing_, BorderOp::kNewVertex);
  }
  /// All tokens are used up to their last op.
  bool finished() const noexcept {
    return run_ == 0 && closing_ == BorderOp::kNewVertex &&
           std::all_of(streams_.begin(), streams_.end(), [](auto s) { return s.empty(); });
  }

 private:
  bool get_token(std::span<const std::byte>& stream) noexcept {
    if (stream.empty()) return false;
    const auto token = std::to_integer<std::uint32_t>(stream.front());
    stream = stream.subspan(1);
    const std::uint32_t closing = token / 32;
    run_ = token % 32;
    // A run of 31 is written as kLongRun, a shorter one with the op that closes it.
    if ((closing == 0) != (run_ == kLongestRun)) return false;
    if (closing > static_cast<std::uint32_t>(BorderOp::kNearSplit)) return false;
    closing_ = static_cast<BorderOp>(closing);
    return true;
  }

  std::array<std::span<const std::byte>, kTokenStreams> streams_;
  std::uint32_t run_ = 0;                    ///< new vertices still to give
  BorderOp closing_ = BorderOp::kNewVertex;  ///< the op after them; kNewVertex stands for none
};

}  // namespace deltamesh
