// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Checks the shape of an asset's JSON once, so that the rest may rely on it.
#pragma once

#include <cstddef>
#include <string_view>
#include <utility>

#include "deltamesh/result.h"
#include "io/gltf/json.h"

namespace deltamesh::gltf {

inline constexpr const char* kExtensionName = "DELTAMESH_mesh_compression";  ///< see gltf_ext/

/// Which primitive: counted over all meshes, and where that is.
struct PrimitiveNumber {
  std::size_t number = 0;
  std::size_t mesh = 0;
  std::size_t in_mesh = 0;
};

/// `error` at a primitive, in place of where it is: shows "mesh 2, primitive 1".
Error at_primitive(Error error, const PrimitiveNumber& primitive) noexcept;

/// kInvalidFile at a primitive.
Error primitive_error(const char* message, const PrimitiveNumber& primitive) noexcept;

/// After success: the members that this library follows have the types that glTF gives them (arrays of
/// objects; primitives with `attributes`), and accessor numbers of primitives are in range. Errors:
/// kInvalidFile, `where`: number of the element in its array, or primitive_error().
Result<void> check_structure(const Json& json);

/// Whether `owner[key]`, where it is there, is an array of objects. Errors: `otherwise`.
Result<void> check_array_of_objects(const Json& owner, const char* key, const Error& otherwise);

/// Calls `visit(primitive, number)` for every primitive; `number`: a PrimitiveNumber.
template <class JsonType, class Visit>
void for_each_primitive(JsonType& json, Visit&& visit) {
  auto* meshes = find(json, "meshes");
  if (!meshes) return;
  PrimitiveNumber number;
  for (auto& mesh : *meshes) {
    number.in_mesh = 0;
    for (auto& primitive : mesh["primitives"]) {
      visit(primitive, std::as_const(number));
      ++number.number;
      ++number.in_mesh;
    }
    ++number.mesh;
  }
}

/// True for an extension that is known to hold no accessor numbers, no vertex numbers, and buffer views only
/// in members named "bufferView".
bool is_harmless_extension(std::string_view name) noexcept;

/// Adds a name to one of the two lists of extensions, once.
void add_extension_name(Json& json, const char* list, const char* name);

/// Removes a name from both lists; a list that becomes empty goes too.
void remove_extension_name(Json& json, const char* name);

}  // namespace deltamesh::gltf
