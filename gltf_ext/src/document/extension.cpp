// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "document/extension.h"

#include <utility>

#include "base/try.h"

namespace deltamesh::gltf {
namespace {

/// Accessors of `map`, attributes or one morph target, that `ids` names.
Result<void> read_uses(const Json& ids, const Json& map, int target, PackedPrimitive& packed) {
  const Error bad =
      rule_error("the extension's attributes do not fit the primitive's", "GLTF-4", packed.number);
  if (!ids.is_object()) return bad;
  for (auto item = ids.begin(); item != ids.end(); ++item) {
    const Json* accessor = find(map, item.key().c_str());
    if (!accessor || (target == kBase && item.key() == "POSITION")) return bad;
    DELTAMESH_TRY(const auto id, to_unsigned(*item, ~std::uint32_t{0}, bad));
    packed.attributes.push_back({{item.key(), target}, accessor->get<std::size_t>(), id});
  }
  return {};
}

Result<void> read_targets(const Json& ids, const Json& primitive, PackedPrimitive& packed) {
  const Error bad =
      rule_error("the extension's morph targets do not fit the primitive's", "GLTF-4", packed.number);
  const Json* targets = find(primitive, "targets");
  if (!ids.is_array() || !targets || ids.size() > targets->size()) return bad;
  for (std::size_t i = 0; i < ids.size(); ++i)
    DELTAMESH_CHECK(read_uses(ids[i], (*targets)[i], static_cast<int>(i), packed));
  return {};
}

}  // namespace

Error rule_error(const char* message, const char* rule, const PrimitiveNumber& primitive) noexcept {
  Error error = primitive_error(message, primitive);
  error.rule = rule;
  return error;
}

Result<std::optional<PackedPrimitive>> read_extension(const Json& primitive, const PrimitiveNumber& number) {
  const Json* extensions = find(primitive, "extensions");
  const Json* extension = extensions ? find(*extensions, kExtensionName) : nullptr;
  if (!extension) return std::optional<PackedPrimitive>();
  PackedPrimitive packed{.number = number};
  const Error bad_view = rule_error("the extension names no buffer view", "GLTF-1", number);
  const Json* view = find(*extension, "bufferView");
  if (!view) return bad_view;
  DELTAMESH_TRY(packed.view, to_unsigned(*view, kNoLimit, bad_view));

  const Error bad_mode =
      rule_error("the extension is on a primitive that is not a list of triangles", "GLTF-2", number);
  DELTAMESH_TRY(const auto mode, unsigned_member(primitive, "mode", 4, 6, bad_mode));
  if (mode != 4) return bad_mode;
  const Error bad_group = rule_error("the extension's group is no number", "GLTF-11", number);
  DELTAMESH_TRY(packed.group, unsigned_member(*extension, "group", 0, ~std::uint32_t{0}, bad_group));
  const Json& attributes = primitive["attributes"];
  const Json* position = find(attributes, "POSITION");
  const Json* indices = find(primitive, "indices");
  if (!position || !indices)
    return rule_error("a compressed primitive needs accessors for POSITION and indices", "GLTF-3", number);
  packed.position = position->get<std::size_t>();
  packed.indices = indices->get<std::size_t>();
  if (const Json* ids = find(*extension, "attributes"))
    DELTAMESH_CHECK(read_uses(*ids, attributes, kBase, packed));
  if (const Json* ids = find(*extension, "targets")) DELTAMESH_CHECK(read_targets(*ids, primitive, packed));
  return std::optional(std::move(packed));
}

void write_extension(Json& primitive, const PackedPrimitive& packed) {
  primitive["attributes"]["POSITION"] = packed.position;
  primitive["indices"] = packed.indices;
  if (Json* mode = find(primitive, "mode")) *mode = 4;  // a strip or fan is a list now
  Json extension = {{"bufferView", packed.view}};
  if (packed.group != 0) extension["group"] = packed.group;
  Json targets = Json::array();
  for (const auto& [semantic, accessor, id] : packed.attributes) {
    if (semantic.target == kBase) {
      primitive["attributes"][semantic.name] = accessor;
      extension["attributes"][semantic.name] = id;
      continue;
    }
    const auto target = static_cast<std::size_t>(semantic.target);
    primitive["targets"][target][semantic.name] = accessor;
    while (targets.size() <= target) targets.push_back(Json::object());
    targets[target][semantic.name] = id;
  }
  if (!targets.empty()) extension["targets"] = std::move(targets);
  primitive["extensions"][kExtensionName] = std::move(extension);
}

void remove_extension(Json& primitive) {
  Json* extensions = find(primitive, "extensions");
  if (!extensions || extensions->erase(kExtensionName) == 0) return;
  if (extensions->empty()) primitive.erase("extensions");
}

}  // namespace deltamesh::gltf
