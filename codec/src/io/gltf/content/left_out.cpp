// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "io/gltf/content/left_out.h"

#include "io/gltf/structure.h"

namespace deltamesh::gltf {

void leave_out_parts(const Json& json, ReadReport& report) {
  // A material of a name alone is what our own writer makes of a group's name.
  std::uint64_t materials = 0;
  if (const Json* const all = find(json, "materials"); all != nullptr && all->is_array())
    for (const Json& material : *all)
      materials += material.is_object() && material.size() <= material.count("name") ? 0 : 1;
  report.leave_out(LeftOutKind::kElements, "materials", materials);
  for (const char* const part : {"textures", "skins", "animations", "cameras"})
    report.leave_out(LeftOutKind::kElements, part, array_size(json, part));
  if (const Json* const extensions = find(json, "extensions"); extensions != nullptr)
    if (const Json* const lights = find(*extensions, "KHR_lights_punctual"); lights != nullptr)
      report.leave_out(LeftOutKind::kElements, "lights", array_size(*lights, "lights"));
  std::uint64_t targets = 0;
  for_each_primitive(
      json, [&](const Json& primitive, std::size_t) { targets += array_size(primitive, "targets"); });
  report.leave_out(LeftOutKind::kVertexValues, "morph targets", targets);
}

}  // namespace deltamesh::gltf
