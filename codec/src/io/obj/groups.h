// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// OBJ's objects, groups and materials as groups of faces.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "deltamesh/io.h"

namespace deltamesh {

/// Faces of the same object, group and material are one group, numbered as they are met.
class ObjGroups {
 public:
  enum Level : std::uint8_t { kObject, kGroup, kMaterial };

  /// For the faces to come.
  void begin(Level level, std::string_view name) {
    now_[level] = name;
    known_ = false;
  }

  void add_face() {
    if (!known_) group_ = groups_.emplace(now_, static_cast<std::uint32_t>(groups_.size())).first->second;
    known_ = true;
    of_faces_.push_back(group_);
  }

  /// The group of every face; empty where all have the same, or where there are more than a mesh can have.
  std::vector<std::uint32_t> take(ReadReport& report) {
    constexpr std::size_t kMostGroups = 1 << 16;
    constexpr std::array<const char*, 3> kNames{"objects", "groups", "materials"};
    for (std::size_t level = 0; level < kNames.size(); ++level) {
      std::set<std::string_view> names;
      for (const auto& [group, number] : groups_) names.insert(group[level]);
      names.erase("");
      report.leave_out(LeftOutKind::kNames, kNames[level], names.size());
    }
    if (groups_.size() > kMostGroups)
      report.leave_out(LeftOutKind::kFaceValues, "groups, more than 65,536", of_faces_.size());
    if (groups_.size() > kMostGroups || groups_.size() < 2) of_faces_.clear();
    return std::move(of_faces_);
  }

 private:
  std::array<std::string, 3> now_;
  std::map<std::array<std::string, 3>, std::uint32_t> groups_;
  bool known_ = false;
  std::uint32_t group_ = 0;
  std::vector<std::uint32_t> of_faces_;
};

}  // namespace deltamesh
