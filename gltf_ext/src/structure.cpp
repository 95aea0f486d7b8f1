// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "structure.h"

#include <algorithm>
#include <string>
#include <utility>

namespace deltamesh::gltf {
namespace {

Result<void> check_array_of_objects(const Json& owner, const char* key, const Error& otherwise) {
  const Json* array = find(owner, key);
  if (!array) return {};
  if (!array->is_array()) return otherwise;
  for (const Json& item : *array)
    if (!item.is_object()) return otherwise;
  return {};
}

/// Every value of an object such as `attributes` is an accessor number.
Result<void> check_accessor_map(const Json& map, std::size_t accessors, std::size_t primitive) {
  const Error bad = element_error("an attribute of the primitive names no accessor", primitive);
  if (!map.is_object()) return bad;
  for (const Json& value : map) {
    const auto number = to_unsigned(value, kNoLimit, bad);
    if (!number || *number >= accessors) return bad;
  }
  return {};
}

Result<void> check_primitive(const Json& primitive, std::size_t accessors, std::size_t number) {
  const Json* attributes = find(primitive, "attributes");
  if (!attributes) return element_error("a primitive without attributes", number);
  if (auto checked = check_accessor_map(*attributes, accessors, number); !checked) return checked;
  if (const Json* indices = find(primitive, "indices")) {
    const Error bad = element_error("the primitive's indices name no accessor", number);
    const auto accessor = to_unsigned(*indices, kNoLimit, bad);
    if (!accessor || *accessor >= accessors) return bad;
  }
  if (const Json* targets = find(primitive, "targets")) {
    if (!targets->is_array()) return element_error("the primitive's targets are not an array", number);
    for (const Json& target : *targets)
      if (auto checked = check_accessor_map(target, accessors, number); !checked) return checked;
  }
  if (const Json* extensions = find(primitive, "extensions"); extensions && !extensions->is_object())
    return element_error("the primitive's extensions are not an object", number);
  return {};
}

Result<void> check_meshes(const Json& json) {
  const std::size_t accessors = array_size(json, "accessors");
  const Json* meshes = find(json, "meshes");
  if (!meshes) return {};
  for (std::size_t i = 0; i < meshes->size(); ++i) {
    const Error bad = element_error("a mesh without a proper list of primitives", i);
    if (array_size((*meshes)[i], "primitives") == 0) return bad;
    if (auto checked = check_array_of_objects((*meshes)[i], "primitives", bad); !checked) return checked;
  }
  Result<void> result;
  for_each_primitive(json, [&](const Json& primitive, std::size_t number) {
    if (result) result = check_primitive(primitive, accessors, number);
  });
  return result;
}

Result<void> check_animations(const Json& json) {
  const Json* animations = find(json, "animations");
  if (!animations) return {};
  for (std::size_t i = 0; i < animations->size(); ++i) {
    const Error bad = element_error("an animation whose samplers are not objects", i);
    if (auto checked = check_array_of_objects((*animations)[i], "samplers", bad); !checked) return checked;
  }
  return {};
}

Result<void> check_other_accessors(const Json& json) {
  const std::size_t accessors = array_size(json, "accessors");
  const Error bad{.code = ErrorCode::kInvalidFile, .message = "a skin or an animation names no accessor"};
  Result<void> result;
  for_each_other_accessor(json, [&](const Json& value) {
    const auto number = to_unsigned(value, kNoLimit, bad);
    if (!number || *number >= accessors) result = bad;
  });
  return result;
}

Result<void> check_version(const Json& json) {
  const Error bad{.code = ErrorCode::kInvalidFile, .message = "not a glTF asset of version 2"};
  const Json* asset = find(json, "asset");
  const Json* version = asset ? find(*asset, "version") : nullptr;
  if (!version || !version->is_string() || !version->get_ref<const std::string&>().starts_with("2."))
    return bad;
  return {};
}

Result<void> check_extension_lists(const Json& json) {
  for (const char* key : {"extensionsUsed", "extensionsRequired"}) {
    const Error bad{.code = ErrorCode::kInvalidFile, .message = "the list of extensions is not one of names"};
    const Json* list = find(json, key);
    if (!list) continue;
    if (!list->is_array()) return bad;
    for (const Json& name : *list)
      if (!name.is_string()) return bad;
  }
  return {};
}

}  // namespace

Result<void> check_structure(const Json& json) {
  if (auto checked = check_version(json); !checked) return checked;
  if (auto checked = check_extension_lists(json); !checked) return checked;
  for (const char* key : {"buffers", "bufferViews", "accessors", "meshes", "skins", "animations"}) {
    const Error bad{.code = ErrorCode::kInvalidFile,
                    .message = "a top-level list holds something else than objects"};
    if (auto checked = check_array_of_objects(json, key, bad); !checked) return checked;
  }
  if (auto checked = check_meshes(json); !checked) return checked;
  if (auto checked = check_animations(json); !checked) return checked;
  return check_other_accessors(json);
}

void add_extension_name(Json& json, const char* list, const char* name) {
  Json& names = json[list];
  if (!names.is_array()) names = Json::array();
  if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

void remove_extension_name(Json& json, const char* name) {
  for (const char* list : {"extensionsUsed", "extensionsRequired"}) {
    Json* names = find(json, list);
    if (!names) continue;
    Json kept = Json::array();
    for (const Json& other : *names)
      if (other != name) kept.push_back(other);
    *names = std::move(kept);
    if (names->empty()) json.erase(list);
  }
}

}  // namespace deltamesh::gltf
