// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <string>

#include "base/byte_reader.h"
#include "connectivity/groups/groups.h"
#include "connectivity/groups/names.h"
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
