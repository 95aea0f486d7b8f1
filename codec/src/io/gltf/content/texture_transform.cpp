// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "io/gltf/content/texture_transform.h"

#include <algorithm>
#include <cmath>
#include <string_view>

namespace deltamesh::gltf {

double uv_scale_of(const Json& json, const Json& primitive) {
  double largest = 1;
  const auto add_transform = [&](const Json& object, std::string_view key) {
    const Json* scale = key == "KHR_texture_transform" ? find(object, "scale") : nullptr;
    if (!scale || !scale->is_array()) return;
    for (const Json& factor : *scale)
      if (factor.is_number() && std::isfinite(factor.get<double>()))
        largest = std::max(largest, std::fabs(factor.get<double>()));
  };
  for_each_object(primitive, [&](const Json& object, std::string_view key) {
    const Json* material = key == "attributes" ? nullptr : find(object, "material");
    const Error none{.code = ErrorCode::kInvalidFile};
    if (!material) return;
    const auto number = to_unsigned(*material, kNoLimit, none);
    if (number && *number < array_size(json, "materials"))
      for_each_object(json["materials"][static_cast<std::size_t>(*number)], add_transform);
  });
  return largest;
}

}  // namespace deltamesh::gltf
