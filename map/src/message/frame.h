// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The frame of all messages of maps: magic, kind, version and checksum [MAP-1].
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/byte_writer.h"
#include "deltamesh/result.h"

namespace deltamesh {

/// Kinds of messages [MAP-1].
enum class MessageKind : std::uint8_t {
  kMap = 1,
  kManifest = 2,
  kEntry = 3,
  kPart = 4,
  kView = 5,
  kStart = 6,
  kPatch = 7,
  kReceipt = 8,
  kFault = 9,
  kPose = 10,
  kFragment = 11
};

/// Begins a message; the body's fields are to follow.
ByteWriter begin_message(MessageKind kind);
/// The whole message: what `out` holds and the checksum.
std::vector<std::byte> end_message(ByteWriter out);

/// The kind in a message's frame. Errors: kBadMagic, kUnsupportedVersion, kTruncated, kInvalidStream [MAP-1].
Result<MessageKind> kind_of_message(std::span<const std::byte> message) noexcept;

/// The body of `message`. Errors: kBadMagic, kUnsupportedVersion, kTruncated, kCorrupt, kInvalidStream
/// (another kind) [MAP-1].
Result<std::span<const std::byte>> open_message(std::span<const std::byte> message,
                                                MessageKind kind) noexcept;

}  // namespace deltamesh
