// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "references.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace deltamesh::gltf {
namespace {

/// Names that end with an underscore stand for all extensions that begin so.
constexpr std::array<std::string_view, 15> kHarmless{"DELTAMESH_mesh_compression",
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

void collect(const Json& root, std::set<std::uint64_t>& numbers) {
  std::vector<const Json*> pending{&root};
  while (!pending.empty()) {
    const Json& value = *pending.back();
    pending.pop_back();
    if (value.is_number_integer() && (value.is_number_unsigned() || value.get<std::int64_t>() >= 0))
      numbers.insert(value.get<std::uint64_t>());
    if (!value.is_structured()) continue;
    for (auto item = value.begin(); item != value.end(); ++item) {
      const bool known = value.is_object() && (item.key() == "bufferView" || item.key() == "extras");
      if (!known) pending.push_back(&*item);
    }
  }
}

}  // namespace

bool is_harmless_extension(std::string_view name) noexcept {
  return std::any_of(kHarmless.begin(), kHarmless.end(), [&](std::string_view known) {
    return known.ends_with('_') ? name.starts_with(known) : name == known;
  });
}

std::set<std::uint64_t> numbers_in_unknown_extensions(Json& json) {
  std::set<std::uint64_t> numbers;
  for_each_object(json, [&](Json& object, std::string_view) {
    const Json* extensions = find(object, "extensions");
    if (!extensions || !extensions->is_object()) return;
    for (auto item = extensions->begin(); item != extensions->end(); ++item)
      if (!is_harmless_extension(item.key())) collect(*item, numbers);
  });
  return numbers;
}

}  // namespace deltamesh::gltf
