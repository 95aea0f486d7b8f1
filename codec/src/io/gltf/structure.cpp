// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "io/gltf/structure.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>

#include "base/try.h"

namespace deltamesh::gltf {
namespace {

/// Names that end with an underscore stand for all extensions that begin so.
constexpr std::array<std::string_view, 15> kHarmless{kExtensionName,
                                                     "KHR_draco_mesh_compression",
                                                     "EXT_meshopt_compression",
                                                     "KHR_meshopt_compression",
                                                     "KHR_mesh_quantization",
                                                     "KHR_lights_punctual",
                                                     "KHR_node_visibility",
                                                     "KHR_xmp_json_ld",
                                                     "KHR_animation_pointer",
                                                     "MSFT_lod",
                                                     "MSFT_texture_dds",
                                                     "KHR_materials_",
                                                     "KHR_texture_",
                                                     "EXT_texture_",
                                                     "EXT_lights_"};

/// Every value of an object such as `attributes` is an accessor number.
Result<void> check_accessor_map(const Json& map, std::size_t accessors, const PrimitiveNumber& primitive) {
  const Error bad = primitive_error("an attribute of the primitive names no accessor", primitive);
  if (!map.is_object()) return bad;
  for (const Json& value : map) {
    const auto number = to_unsigned(value, kNoLimit, bad);
    if (!number || *number >= accessors) return bad;
  }
  return {};
}

Result<void> check_primitive(const Json& primitive, std::size_t accessors, const PrimitiveNumber& number) {
  const Json* attributes = find(primitive, "attributes");
  if (!attributes) return primitive_error("a primitive without attributes", number);
  DELTAMESH_CHECK(check_accessor_map(*attributes, accessors, number));
  if (const Json* indices = find(primitive, "indices")) {
    const Error bad = primitive_error("the primitive's indices name no accessor", number);
    const auto accessor = to_unsigned(*indices, kNoLimit, bad);
    if (!accessor || *accessor >= accessors) return bad;
  }
  if (const Json* targets = find(primitive, "targets")) {
    if (!targets->is_array()) return primitive_error("the primitive's targets are not an array", number);
    for (const Json& target : *targets) DELTAMESH_CHECK(check_accessor_map(target, accessors, number));
  }
  if (const Json* extensions = find(primitive, "extensions"); extensions && !extensions->is_object())
    return primitive_error("the primitive's extensions are not an object", number);
  return {};
}

Result<void> check_meshes(const Json& json) {
  const std::size_t accessors = array_size(json, "accessors");
  const Json* meshes = find(json, "meshes");
  if (!meshes) return {};
  for (std::size_t i = 0; i < meshes->size(); ++i) {
    const Error bad = element_error("a mesh without a proper list of primitives", i);
    if (!(*meshes)[i].contains("primitives")) return bad;
    DELTAMESH_CHECK(check_array_of_objects((*meshes)[i], "primitives", bad));
  }
  Result<void> result;
  for_each_primitive(json, [&](const Json& primitive, const PrimitiveNumber& number) {
    if (result) result = check_primitive(primitive, accessors, number);
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

Error at_primitive(Error error, const PrimitiveNumber& primitive) noexcept {
  error.where_kind = WhereKind::kPrimitive;
  error.where = primitive.number;
  std::snprintf(error.found.data(), error.found.size(), "mesh %zu, primitive %zu", primitive.mesh,
                primitive.in_mesh);
  return error;
}

Error primitive_error(const char* message, const PrimitiveNumber& primitive) noexcept {
  return at_primitive({.code = ErrorCode::kInvalidFile, .message = message}, primitive);
}

Result<void> check_array_of_objects(const Json& owner, const char* key, const Error& otherwise) {
  const Json* array = find(owner, key);
  if (!array) return {};
  if (!array->is_array()) return otherwise;
  for (const Json& item : *array)
    if (!item.is_object()) return otherwise;
  return {};
}

Result<void> check_structure(const Json& json) {
  DELTAMESH_CHECK(check_version(json));
  DELTAMESH_CHECK(check_extension_lists(json));
  for (const char* key : {"buffers", "bufferViews", "accessors", "meshes", "nodes", "scenes"}) {
    const Error bad{.code = ErrorCode::kInvalidFile,
                    .message = "a top-level list holds something else than objects"};
    DELTAMESH_CHECK(check_array_of_objects(json, key, bad));
  }
  return check_meshes(json);
}

bool is_harmless_extension(std::string_view name) noexcept {
  return std::any_of(kHarmless.begin(), kHarmless.end(), [&](std::string_view known) {
    return known.ends_with('_') ? name.starts_with(known) : name == known;
  });
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
