// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Groups of faces from an asset's primitives: those of the same mesh and material are one.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "deltamesh/io.h"
#include "io/gltf/json.h"
#include "io/names.h"

namespace deltamesh::gltf {

class PrimitiveGroups {
 public:
  explicit PrimitiveGroups(const Json& json) : json_(json) {}

  /// Of a primitive of mesh number `mesh`. Groups are numbered as they are met. A material that the asset
  /// does not have is one without a name.
  std::uint32_t number_of(const Json& primitive, std::size_t mesh) {
    Key key{.mesh = mesh, .name = {}};
    key.name.object = text_of(json_["meshes"][mesh], "name");
    if (const Json* const extras = find(primitive, "extras"); extras != nullptr) {
      if (const std::string object = text_of(*extras, "object"); !object.empty()) key.name.object = object;
      key.name.group = text_of(*extras, "group");
    }
    if (const Json* const index = find(primitive, "material");
        index != nullptr && index->is_number_unsigned()) {
      key.material = index->get<std::uint64_t>();
      if (*key.material < array_size(json_, "materials"))
        key.name.material = text_of(json_["materials"][static_cast<std::size_t>(*key.material)], "name");
    }
    return groups_.emplace(key, static_cast<std::uint32_t>(groups_.size())).first->second;
  }

  void add_faces(std::uint32_t group, std::size_t count) { of_faces_.insert(of_faces_.end(), count, group); }

  /// As NamedGroups does.
  void move_into(Imported& imported) {
    if (groups_.size() > kMostGroups)
      return imported.report.leave_out(LeftOutKind::kFaceValues, "groups, more than 65,536",
                                       of_faces_.size());
    bool has_names = false;
    for (const auto& [key, number] : groups_) has_names = has_names || key.name != GroupName{};
    if (has_names) imported.mesh.group_names.resize(groups_.size());
    if (has_names)
      for (const auto& [key, number] : groups_) imported.mesh.group_names[number] = key.name;
    if (groups_.size() > 1) imported.mesh.face_groups = std::move(of_faces_);
  }

 private:
  struct Key {
    std::size_t mesh = 0;
    std::optional<std::uint64_t> material{};  ///< its number, which may be beyond the array
    GroupName name;
    bool operator<(const Key& other) const noexcept {
      return std::tie(mesh, material, name) < std::tie(other.mesh, other.material, other.name);
    }
  };

  static std::string text_of(const Json& object, const char* key) {
    const Json* const text = find(object, key);
    if (text == nullptr || !text->is_string()) return {};
    const auto& name = text->get_ref<const std::string&>();
    return is_attribute_name(name) ? name : std::string();
  }

  const Json& json_;
  std::map<Key, std::uint32_t> groups_;
  std::vector<std::uint32_t> of_faces_;
};

}  // namespace deltamesh::gltf
