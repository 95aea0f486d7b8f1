// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <string>
#include <utility>

#include "base/broken_rule.h"
#include "base/byte_reader.h"
#include "base/try.h"
#include "connectivity/groups/coder.h"
#include "connectivity/groups/groups.h"
#include "entropy/coder/reader.h"
#include "format/chunk/tags.h"

namespace deltamesh {
namespace {

bool read_name(ByteReader& in, std::string& name) {
  const auto size = in.read<std::uint8_t>();
  if (!size) return false;
  const auto letters = in.read_bytes(*size);
  if (!letters) return false;
  name.assign(reinterpret_cast<const char*>(letters->data()), letters->size());
  return true;
}

}  // namespace

Result<std::vector<std::uint32_t>> read_face_groups(std::span<const std::byte> payload,
                                                    std::span<const std::uint32_t> triangles,
                                                    std::uint32_t vertex_count) {
  if (payload.empty()) return std::vector<std::uint32_t>();
  std::vector<std::uint32_t> groups(triangles.size() / 3);
  CompactReader reader(payload);
  const char* const broken = FaceGroupCoder<CompactReader>(reader, triangles, vertex_count).code(groups);
  if (reader.failed() || broken == nullptr) DELTAMESH_CHECK(reader.finish(kTagFaceGroups));
  if (broken != nullptr) return broken_rule("not the number of a group of faces", broken, kTagFaceGroups);
  return groups;
}

std::vector<GroupName> read_group_names(std::span<const std::byte> payload) {
  ByteReader in(payload, kTagGroupNames);
  std::vector<GroupName> names;
  while (in.remaining() > 0) {
    GroupName name;
    if (names.size() == kMostGroups || !read_name(in, name.object) || !read_name(in, name.group) ||
        !read_name(in, name.material))
      return {};
    names.push_back(std::move(name));
  }
  return names;
}

}  // namespace deltamesh
