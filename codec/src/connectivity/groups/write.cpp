// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>
#include <string_view>

#include "base/byte_writer.h"
#include "connectivity/groups/coder.h"
#include "connectivity/groups/groups.h"
#include "entropy/coder/writer.h"

namespace deltamesh {
namespace {

void write_name(ByteWriter& out, std::string_view name) {
  name = name.substr(0, kMostNameBytes);
  out.write(static_cast<std::uint8_t>(name.size()));
  out.write_bytes(std::as_bytes(std::span(name.data(), name.size())));
}

}  // namespace

std::vector<std::byte> write_face_groups(std::vector<std::uint32_t> groups,
                                         std::span<const std::uint32_t> triangles,
                                         std::uint32_t vertex_count) {
  if (groups.empty()) return {};
  CompactWriter writer;
  FaceGroupCoder<CompactWriter>(writer, triangles, vertex_count).code(groups);
  return writer.finish();
}

std::vector<std::byte> write_group_names(std::span<const GroupName> names) {
  const auto has_name = [](const GroupName& name) { return name != GroupName{}; };
  if (names.size() > kMostGroups || !std::any_of(names.begin(), names.end(), has_name)) return {};
  ByteWriter out;
  for (const GroupName& name : names) {
    write_name(out, name.object);
    write_name(out, name.group);
    write_name(out, name.material);
  }
  if (out.size() > kMostNamesBytes) return {};
  return out.take();
}

}  // namespace deltamesh
