// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "message/frame.h"

#include <array>

#include "base/byte_reader.h"
#include "base/try.h"
#include "format/container_frame.h"
#include "format/header.h"

namespace deltamesh {
namespace {

constexpr std::array<char, 3> kMessageMagic{'D', 'M', 'M'};

/// Letters and version.
Result<void> read_start(ByteReader& in) noexcept {
  for (const char expected : kMessageMagic) {
    DELTAMESH_TRY(const auto letter, in.read<char>());
    if (letter != expected)
      return in.error(ErrorCode::kBadMagic, "not a message of a deltamesh map", "MAP-1");
  }
  DELTAMESH_TRY(const auto version, in.read<std::uint8_t>());
  if (version != kFormatVersion)
    return in.error(ErrorCode::kUnsupportedVersion, "a message of another format version", "MAP-1");
  return {};
}

}  // namespace

ByteWriter begin_message(MessageKind kind) {
  ByteWriter out;
  for (const char letter : kMessageMagic) out.write(letter);
  out.write(kFormatVersion);
  out.write(static_cast<std::uint8_t>(kind));
  return out;
}

std::vector<std::byte> end_message(ByteWriter out) {
  out.write(checksum_of(out.bytes()));
  return out.take();
}

Result<MessageKind> kind_of_message(std::span<const std::byte> message) noexcept {
  ByteReader in(message);
  DELTAMESH_CHECK(read_start(in));
  DELTAMESH_TRY(const auto kind, in.read<std::uint8_t>());
  if (kind < static_cast<std::uint8_t>(MessageKind::kMap) ||
      kind > static_cast<std::uint8_t>(MessageKind::kFragment))
    return in.error(ErrorCode::kInvalidStream, "no such kind of message", "MAP-1");
  return static_cast<MessageKind>(kind);
}

Result<std::span<const std::byte>> open_message(std::span<const std::byte> message,
                                                MessageKind kind) noexcept {
  ByteReader in(message);
  DELTAMESH_CHECK(read_start(in));
  DELTAMESH_TRY(const auto stored_kind, in.read<std::uint8_t>());
  if (in.remaining() < kChecksumBytes)
    return in.error(ErrorCode::kTruncated, "bytes end before the checksum", "MAP-1");
  DELTAMESH_TRY(const auto covered,
                check_whole(message, "the checksum does not match: the message is damaged or cut off",
                            "MAP-1", checksum_of));
  if (stored_kind != static_cast<std::uint8_t>(kind))
    return in.error(ErrorCode::kInvalidStream, "a message of another kind", "MAP-1");
  return covered.subspan(in.position());
}

}  // namespace deltamesh
