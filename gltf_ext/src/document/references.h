// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// References to accessors outside primitives, and numbers that extensions unknown to us may mean as such.
#pragma once

#include <cstdint>
#include <set>

#include "io/gltf/structure.h"

namespace deltamesh::gltf {

/// Every whole number inside an extension that is not harmless, except members named "bufferView" and extras.
/// An accessor or buffer view with such a number must keep number and content: any of them may be meant.
std::set<std::uint64_t> numbers_in_unknown_extensions(const Json& json);

/// Calls `visit(accessor number)`, a Json, for every reference to an accessor that animation samplers make.
template <class JsonType, class Visit>
void for_each_sampled_accessor(JsonType& json, Visit&& visit) {
  if (auto* animations = find(json, "animations"))
    for (auto& animation : *animations)
      if (auto* samplers = find(animation, "samplers"))
        for (auto& sampler : *samplers)
          for (const char* key : {"input", "output"})
            if (auto* accessor = find(sampler, key)) visit(*accessor);
}

/// The same for every one that core glTF makes outside primitives: inverse bind matrices and animation
/// samplers.
template <class JsonType, class Visit>
void for_each_other_accessor(JsonType& json, Visit&& visit) {
  if (auto* skins = find(json, "skins"))
    for (auto& skin : *skins)
      if (auto* matrices = find(skin, "inverseBindMatrices")) visit(*matrices);
  for_each_sampled_accessor(json, visit);
}

/// Whether those references are what glTF wants: the rest may rely on it. Errors: kInvalidFile.
Result<void> check_other_accessors(const Json& json);

}  // namespace deltamesh::gltf
