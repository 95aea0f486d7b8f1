// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// OBJ's objects, groups and materials, and STL's solids, as groups of faces.
#pragma once

#include <cstdint>
#include <map>
#include <string_view>
#include <vector>

#include "deltamesh/io.h"
#include "io/names.h"
#include "io/polygons/mesh.h"

namespace deltamesh {

/// Faces of the same names are one group, numbered as they are met.
class NamedGroups {
 public:
  /// For the faces to come. Names that are not UTF-8 of at most 255 bytes are left out.
  void begin(std::string GroupName::*level, std::string_view name, ReadReport& report) {
    const bool fits = name.empty() || is_attribute_name(name);
    if (!fits) report.leave_out(LeftOutKind::kNames, "groups, too long or not UTF-8");
    now_.*level = fits ? name : "";
    known_ = false;
  }

  void add_face() {
    if (!known_) group_ = groups_.emplace(now_, static_cast<std::uint32_t>(groups_.size())).first->second;
    known_ = true;
    of_faces_.push_back(group_);
  }

  /// Groups and their names; no numbers where all faces have the same group, or where there are more groups
  /// than a mesh can have.
  void move_into(PolygonMesh& mesh, ReadReport& report) {
    if (groups_.size() > kMostGroups)
      return report.leave_out(LeftOutKind::kFaceValues, "groups, more than 65,536", of_faces_.size());
    const bool has_names =
        groups_.size() > 1 || (groups_.size() == 1 && groups_.begin()->first != GroupName{});
    if (has_names) mesh.group_names.resize(groups_.size());
    if (has_names)
      for (const auto& [name, number] : groups_) mesh.group_names[number] = name;
    if (groups_.size() > 1) mesh.face_groups = std::move(of_faces_);
  }

 private:
  GroupName now_;
  std::map<GroupName, std::uint32_t> groups_;
  bool known_ = false;
  std::uint32_t group_ = 0;
  std::vector<std::uint32_t> of_faces_;
};

}  // namespace deltamesh
