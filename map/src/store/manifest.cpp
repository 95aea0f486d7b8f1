// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors

#include "base/byte_reader.h"
#include "base/byte_writer.h"
#include "base/guard.h"
#include "base/try.h"
#include "deltamesh/map/folder.h"
#include "message/entry_fields.h"
#include "message/frame.h"

namespace deltamesh {
namespace {

Result<void> check_entries(const MapManifest& manifest, ErrorCode code) noexcept {
  const auto invalid = [code](const char* message) {
    return Error{.code = code, .message = message, .rule = "MAP-10"};
  };
  const PartEntry* before = nullptr;
  for (const PartEntry& entry : manifest.entries) {
    if (before != nullptr && before->key >= entry.key) return invalid("entries that do not ascend by key");
    if (entry.bytes == 0) return invalid("an entry of a part that is gone");
    if (entry.revision > manifest.revision) return invalid("an entry newer than its manifest");
    if (entry.group >= manifest.next_group) return invalid("an entry of a group that is still to come");
    if (entry.attribute_errors.size() != manifest.description.attributes.size())
      return invalid("an entry without an error for each attribute");
    before = &entry;
  }
  return {};
}

Result<MapManifest> read_entries(ByteReader in) {
  MapManifest manifest;
  DELTAMESH_TRY(const auto size, in.read_varint());
  DELTAMESH_TRY(const auto description, in.read_bytes(size));
  DELTAMESH_TRY(manifest.description, read_description(description));
  DELTAMESH_TRY(manifest.revision, in.read_varint());
  DELTAMESH_TRY(manifest.next_group, in.read_varint());
  while (in.remaining() > 0) {
    DELTAMESH_TRY(PartEntry entry, read_entry_fields(in, manifest.description.attributes.size()));
    manifest.entries.push_back(std::move(entry));
  }
  DELTAMESH_CHECK(check_entries(manifest, ErrorCode::kInvalidStream));
  return manifest;
}

}  // namespace

Result<std::vector<std::byte>> write_manifest(const MapManifest& manifest) noexcept {
  return guarded([&]() -> Result<std::vector<std::byte>> {
    DELTAMESH_CHECK(check_entries(manifest, ErrorCode::kInvalidArgument));
    DELTAMESH_TRY(const auto description, write_description(manifest.description));
    ByteWriter out = begin_message(MessageKind::kManifest);
    out.write_varint(description.size());
    out.write_bytes(description);
    out.write_varint(manifest.revision);
    out.write_varint(manifest.next_group);
    for (const PartEntry& entry : manifest.entries) {
      DELTAMESH_CHECK(check_entry(entry));
      write_entry_fields(out, entry);
    }
    return end_message(std::move(out));
  });
}

Result<MapManifest> read_manifest(std::span<const std::byte> bytes) noexcept {
  return guarded([&]() -> Result<MapManifest> {
    DELTAMESH_TRY(const auto body, open_message(bytes, MessageKind::kManifest));
    return read_entries(ByteReader(body));
  });
}

}  // namespace deltamesh
