// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Checks the shape of an asset's JSON once, so that the rest may rely on it.
#pragma once

#include "deltamesh/result.h"
#include "json.h"

namespace deltamesh::gltf {

/// After success: the members that this library follows have the types that glTF gives them (arrays of
/// objects; primitives with `attributes`), and accessor and view numbers in accessors, primitives, skins and
/// animations are in range. Errors: kInvalidFile, `where`: number of the element in its array; for primitives
/// counted over all meshes.
Result<void> check_structure(const Json& json);

/// Calls `visit(primitive, number)` for every primitive, numbered over all meshes.
template <class JsonType, class Visit>
void for_each_primitive(JsonType& json, Visit&& visit) {
  auto* meshes = find(json, "meshes");
  if (!meshes) return;
  std::size_t number = 0;
  for (auto& mesh : *meshes)
    for (auto& primitive : mesh["primitives"]) visit(primitive, number++);
}

/// Adds a name to one of the two lists of extensions, once.
void add_extension_name(Json& json, const char* list, const char* name);

/// Removes a name from both lists; a list that becomes empty goes too.
void remove_extension_name(Json& json, const char* name);

/// Calls `visit(accessor number)`, a Json, for every reference to an accessor that core glTF makes outside
/// primitives: inverse bind matrices and animation samplers.
template <class JsonType, class Visit>
void for_each_other_accessor(JsonType& json, Visit&& visit) {
  if (auto* skins = find(json, "skins"))
    for (auto& skin : *skins)
      if (auto* matrices = find(skin, "inverseBindMatrices")) visit(*matrices);
  if (auto* animations = find(json, "animations"))
    for (auto& animation : *animations)
      if (auto* samplers = find(animation, "samplers"))
        for (auto& sampler : *samplers)
          for (const char* key : {"input", "output"})
            if (auto* accessor = find(sampler, key)) visit(*accessor);
}

}  // namespace deltamesh::gltf
