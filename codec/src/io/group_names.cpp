// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "io/group_names.h"

#include <algorithm>
#include <set>
#include <string>

#include "io/attribute_name.h"

namespace deltamesh {
namespace {

void clean(std::string& name) {
  const bool fits = name.empty() || is_attribute_name(name);
  for (char& c : name) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < ' ' || byte == 0x7f || (!fits && byte > 0x7f)) c = '_';
  }
}

}  // namespace

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
