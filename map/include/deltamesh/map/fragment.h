// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Messages cut into fragments for transports with a largest size, and put together again. MapSender and
// MapReceiver do both by themselves.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "deltamesh/result.h"

namespace deltamesh {

/// A piece of a message [MAP-25].
struct FragmentMessage {
  std::uint64_t id = 0;      ///< xxh3-64 of the message
  std::uint64_t size = 0;    ///< of the message in bytes, at most kMostMessageBytes
  std::uint64_t offset = 0;  ///< of the octets in it
  std::vector<std::byte> octets{};
};
inline constexpr std::size_t kMostMessageBytes = std::size_t{1} << 18;  // [MAP-25]
inline constexpr std::size_t kLeastFragment = 64;  ///< bytes that a message may always have

/// Errors: kInvalidArgument (out of range), kOutOfMemory.
Result<std::vector<std::byte>> write_fragment(const FragmentMessage& fragment) noexcept;
/// Errors: 1xx codes [MAP-1, MAP-25], kOutOfMemory.
Result<FragmentMessage> read_fragment(std::span<const std::byte> message) noexcept;

/// The message as it is if it has at most `most` bytes, or `most` is 0; else as fragments of at most so many,
/// each with 24 bytes more than it carries. `most`: 0, or kLeastFragment or more. Errors: kInvalidArgument,
/// kOutOfMemory.
Result<std::vector<std::vector<std::byte>>> cut_message(std::vector<std::byte> message,
                                                        std::size_t most) noexcept;

/// Puts fragments together, in any order. Holds at most 64 messages and 1 MiB, and forgets the oldest then.
class FragmentJoiner {
 public:
  /// The message, if this was its last fragment; nothing if some are missing. Errors: as read_fragment(),
  /// kCorrupt (what they make is not what they say).
  Result<std::optional<std::vector<std::byte>>> add(std::span<const std::byte> fragment) noexcept;

 private:
  struct Begun {
    std::uint64_t id = 0;
    std::vector<std::byte> bytes{};
    std::vector<bool> has{};  ///< which of these
    std::size_t missing = 0;
  };
  Begun& begun_for(const FragmentMessage& fragment);

  std::deque<Begun> begun_{};  ///< the oldest first
};

}  // namespace deltamesh
