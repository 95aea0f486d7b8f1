// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "io/names.h"

#include <algorithm>
#include <set>
#include <string>

#include "format/chunk/attribute_descriptor.h"

namespace deltamesh {
namespace {

/// Bytes of the UTF-8 character at the front of `text`; 0 where it is malformed.
std::size_t character_size(std::string_view text) noexcept {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
  const std::uint8_t first = byte(0);
  if (first < 0x80) return 1;
  const std::size_t size = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  if (first < 0xc2 || first > 0xf4 || text.size() < size) return 0;
  for (std::size_t i = 1; i < size; ++i)
    if ((byte(i) & 0xc0) != 0x80) return 0;
  const std::uint8_t second = byte(1);
  const bool overlong = (first == 0xe0 && second < 0xa0) || (first == 0xf0 && second < 0x90);
  const bool surrogate = first == 0xed && second >= 0xa0;
  const bool too_large = first == 0xf4 && second >= 0x90;
  return overlong || surrogate || too_large ? 0 : size;
}

void clean(std::string& name) {
  const bool fits = name.empty() || is_attribute_name(name);
  for (char& c : name) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < ' ' || byte == 0x7f || (!fits && byte > 0x7f)) c = '_';
  }
}

}  // namespace

bool is_attribute_name(std::string_view name) noexcept {
  if (name.empty() || name.size() > kMaxAttributeName) return false;
  while (!name.empty()) {
    const std::size_t size = character_size(name);
    if (size == 0) return false;
    name.remove_prefix(size);
  }
  return true;
}

std::vector<GroupName> distinct_names(const MeshView& mesh) {
  const auto last = std::max_element(mesh.face_groups.begin(), mesh.face_groups.end());
  std::vector<GroupName> names(mesh.group_names.begin(), mesh.group_names.end());
  const bool one = last == mesh.face_groups.end();
  if (one && (names.empty() || names[0] == GroupName{})) return {};
  names.resize(one ? 1 : std::size_t{*last} + 1);
  std::vector<bool> used(names.size(), one);
  for (const std::uint32_t group : mesh.face_groups) used[group] = true;
  std::set<GroupName> taken;
  for (std::size_t g = 0; g < names.size(); ++g) {
    GroupName& name = names[g];
    for (std::string* const text : {&name.object, &name.group, &name.material}) clean(*text);
    if (!used[g]) continue;
    if (name == GroupName{}) name.group = "group_" + std::to_string(g);
    while (!taken.insert(name).second)
      name.group += (name.group.empty() ? "group_" : "_") + std::to_string(g);
  }
  return names;
}

std::vector<std::vector<std::uint32_t>> corners_by_group(const MeshView& mesh, std::size_t count) {
  std::vector<std::vector<std::uint32_t>> corners(count);
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const auto face = mesh.triangles.subspan(3 * t, 3);
    std::vector<std::uint32_t>& own = corners[mesh.face_groups.empty() ? 0 : mesh.face_groups[t]];
    own.insert(own.end(), face.begin(), face.end());
  }
  return corners;
}

}  // namespace deltamesh
