// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "io/gltf_filter.h"

#include <algorithm>
#include <initializer_list>
#include <nlohmann/json.hpp>

#include "io/io_error.h"

namespace deltamesh {
namespace {

using nlohmann::json;

bool is_plain(const json& value) {
  if (!value.is_array()) return value.is_primitive();
  return std::all_of(value.begin(), value.end(), [](const json& entry) { return entry.is_number(); });
}

/// Copies what is listed and has a harmless shape; remembers whether anything had not.
class Filter {
 public:
  bool ok() const noexcept { return ok_; }

  /// The named members of an object that are scalars or arrays of numbers.
  json members(const json& object, std::initializer_list<const char*> names) {
    json result = json::object();
    if (!expect(object.is_object())) return result;
    for (const char* const name : names) {
      const auto found = object.find(name);
      if (found == object.end()) continue;
      if (expect(is_plain(*found))) result[name] = *found;
    }
    return result;
  }

  /// Member `name`, passed through `change`; left out where absent.
  template <class F>
  void member(const json& object, const char* name, json& result, const F& change) {
    if (!object.is_object()) return;
    const auto found = object.find(name);
    if (found != object.end()) result[name] = change(*found);
  }

  /// The array `name`, every entry passed through `change`.
  template <class F>
  void array(const json& object, const char* name, json& result, const F& change) {
    member(object, name, result, [&](const json& entries) {
      json changed = json::array();
      if (!expect(entries.is_array())) return changed;
      for (const json& entry : entries) changed.push_back(change(entry));
      return changed;
    });
  }

  json accessor(const json& source) {
    json result =
        members(source, {"bufferView", "byteOffset", "normalized", "componentType", "count", "type"});
    member(source, "sparse", result, [this](const json& sparse) {
      json copy = members(sparse, {"count"});
      for (const char* const part : {"indices", "values"})
        member(sparse, part, copy, [this](const json& view) {
          return members(view, {"bufferView", "byteOffset", "componentType"});
        });
      return copy;
    });
    return result;
  }

  json mesh(const json& source) {
    json result = json::object();
    if (!expect(source.is_object())) return result;
    array(source, "primitives", result, [this](const json& primitive) {
      json copy = members(primitive, {"indices", "mode"});
      member(primitive, "attributes", copy, [this](const json& attributes) {
        const bool numbers = attributes.is_object() &&
                             std::all_of(attributes.begin(), attributes.end(),
                                         [](const json& accessor) { return accessor.is_number_integer(); });
        return expect(numbers) ? attributes : json::object();
      });
      return copy;
    });
    return result;
  }

 private:
  bool expect(bool condition) noexcept {
    ok_ = ok_ && condition;
    return condition;
  }

  bool ok_ = true;
};

}  // namespace

Result<std::string> filtered_gltf(const json& root) {
  Filter filter;
  json result = filter.members(root, {"scene"});
  filter.member(root, "asset", result, [&](const json& asset) { return filter.members(asset, {"version"}); });
  filter.array(root, "bufferViews", result, [&](const json& view) {
    return filter.members(view, {"buffer", "byteOffset", "byteLength", "byteStride"});
  });
  filter.array(root, "accessors", result, [&](const json& accessor) { return filter.accessor(accessor); });
  filter.array(root, "meshes", result, [&](const json& mesh) { return filter.mesh(mesh); });
  filter.array(root, "nodes", result, [&](const json& node) {
    return filter.members(node, {"mesh", "children", "matrix", "rotation", "scale", "translation"});
  });
  filter.array(root, "scenes", result, [&](const json& scene) { return filter.members(scene, {"nodes"}); });
  if (!filter.ok()) return invalid_file("glTF: a property has a type that the schema does not allow");
  return result.dump();
}

}  // namespace deltamesh
