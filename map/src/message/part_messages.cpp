// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Start, entry, part and patch messages [MAP-13, MAP-14, MAP-16, MAP-17].
#include "base/guard.h"
#include "base/try.h"
#include "deltamesh/map/messages.h"
#include "deltamesh/map/part.h"
#include "message/entry_fields.h"
#include "message/frame.h"

namespace deltamesh {
namespace {

constexpr const char* kNoOctets = "a part without octets, or with too many";

Result<EntryMessage> read_entry_body(ByteReader in, std::size_t attributes) {
  EntryMessage message;
  DELTAMESH_TRY(message.map, in.read<std::uint64_t>());
  DELTAMESH_TRY(message.start, in.read_varint());
  DELTAMESH_TRY(message.number, in.read_varint());
  DELTAMESH_TRY(message.entry, read_entry_fields(in, attributes));
  DELTAMESH_CHECK(in.finish());
  return message;
}

/// All but the octets.
Result<PartMessage> read_part_fields(ByteReader& in) {
  PartMessage message;
  DELTAMESH_TRY(message.map, in.read<std::uint64_t>());
  DELTAMESH_TRY(message.start, in.read_varint());
  DELTAMESH_TRY(message.number, in.read_varint());
  DELTAMESH_TRY(message.key, read_key(in));
  DELTAMESH_TRY(message.revision, in.read_varint());
  DELTAMESH_TRY(message.group, in.read_varint());
  DELTAMESH_TRY(message.links, read_links(in, message.key, message.revision));
  return message;
}

/// All that is left.
Result<std::vector<std::byte>> read_octets(ByteReader& in, const char* rule) {
  if (in.remaining() == 0 || in.remaining() > kMostPartBytes)
    return in.error(ErrorCode::kInvalidStream, kNoOctets, rule);
  DELTAMESH_TRY(const auto octets, in.read_bytes(in.remaining()));
  return std::vector<std::byte>(octets.begin(), octets.end());
}

void write_part_fields(ByteWriter& out, const PartMessage& message) {
  out.write(message.map);
  out.write_varint(message.start);
  out.write_varint(message.number);
  write_key(out, message.key);
  out.write_varint(message.revision);
  out.write_varint(message.group);
  write_links(out, message.key, message.revision, message.links);
}

Result<void> check_octets(const std::vector<std::byte>& octets, const char* rule) {
  if (octets.empty() || octets.size() > kMostPartBytes)
    return Error{.code = ErrorCode::kInvalidArgument, .message = kNoOctets, .rule = rule};
  return {};
}

}  // namespace

Result<std::vector<std::byte>> write_start(const StartMessage& message) noexcept {
  return guarded([&]() -> Result<std::vector<std::byte>> {
    ByteWriter out = begin_message(MessageKind::kStart);
    out.write(message.map);
    out.write_varint(message.start);
    out.write_varint(message.number);
    return end_message(std::move(out));
  });
}

Result<StartMessage> read_start(std::span<const std::byte> message) noexcept {
  return guarded([&]() -> Result<StartMessage> {
    DELTAMESH_TRY(const auto body, open_message(message, MessageKind::kStart));
    ByteReader in(body);
    StartMessage start;
    DELTAMESH_TRY(start.map, in.read<std::uint64_t>());
    DELTAMESH_TRY(start.start, in.read_varint());
    DELTAMESH_TRY(start.number, in.read_varint());
    DELTAMESH_CHECK(in.finish());
    return start;
  });
}

Result<std::vector<std::byte>> write_entry(const EntryMessage& message) noexcept {
  return guarded([&]() -> Result<std::vector<std::byte>> {
    DELTAMESH_CHECK(check_entry(message.entry));
    ByteWriter out = begin_message(MessageKind::kEntry);
    out.write(message.map);
    out.write_varint(message.start);
    out.write_varint(message.number);
    write_entry_fields(out, message.entry);
    return end_message(std::move(out));
  });
}

Result<std::vector<std::byte>> write_part(const PartMessage& message) noexcept {
  return guarded([&]() -> Result<std::vector<std::byte>> {
    DELTAMESH_CHECK(check_links(message.key, message.links));
    DELTAMESH_CHECK(check_octets(message.octets, "MAP-14"));
    ByteWriter out = begin_message(MessageKind::kPart);
    write_part_fields(out, message);
    out.write_bytes(message.octets);
    return end_message(std::move(out));
  });
}

Result<std::vector<std::byte>> write_patch(const PatchMessage& message) noexcept {
  return guarded([&]() -> Result<std::vector<std::byte>> {
    DELTAMESH_CHECK(check_links(message.part.key, message.part.links));
    DELTAMESH_CHECK(check_octets(message.body, "MAP-17"));
    ByteWriter out = begin_message(MessageKind::kPatch);
    write_part_fields(out, message.part);
    write_neighbor(out, message.part.key, {message.base_key, 0});
    out.write_bytes(message.body);
    return end_message(std::move(out));
  });
}

Result<EntryMessage> read_entry(std::span<const std::byte> message, std::size_t attributes) noexcept {
  return guarded([&]() -> Result<EntryMessage> {
    DELTAMESH_TRY(const auto body, open_message(message, MessageKind::kEntry));
    return read_entry_body(ByteReader(body), attributes);
  });
}

Result<PartMessage> read_part(std::span<const std::byte> message) noexcept {
  return guarded([&]() -> Result<PartMessage> {
    DELTAMESH_TRY(const auto body, open_message(message, MessageKind::kPart));
    ByteReader in(body);
    DELTAMESH_TRY(PartMessage part, read_part_fields(in));
    DELTAMESH_TRY(part.octets, read_octets(in, "MAP-14"));
    return part;
  });
}

Result<PatchMessage> read_patch(std::span<const std::byte> message) noexcept {
  return guarded([&]() -> Result<PatchMessage> {
    DELTAMESH_TRY(const auto body, open_message(message, MessageKind::kPatch));
    ByteReader in(body);
    PatchMessage patch;
    DELTAMESH_TRY(patch.part, read_part_fields(in));
    DELTAMESH_TRY(const Neighbor base, read_neighbor(in, patch.part.key));
    if (base.flags != 0) return in.error(ErrorCode::kInvalidStream, "a base with a mark", "MAP-18");
    patch.base_key = base.key;
    DELTAMESH_TRY(patch.body, read_octets(in, "MAP-17"));
    return patch;
  });
}

}  // namespace deltamesh
