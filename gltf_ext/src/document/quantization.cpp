// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "document/quantization.h"

#include "document/semantics.h"
#include "io/gltf/structure.h"

namespace deltamesh::gltf {
namespace {

bool is_core_map(const Document& document, const Json& map, int target) {
  for (auto item = map.begin(); item != map.end(); ++item) {
    const auto shape = accessor_shape(document, item->get<std::size_t>());
    if (shape && *shape && !is_core_shape({item.key(), target}, **shape)) return false;
  }
  return true;
}

}  // namespace

void drop_needless_quantization(Document& document) {
  bool needed = false;
  for_each_primitive(document.json, [&](const Json& primitive, const PrimitiveNumber&) {
    needed |= !is_core_map(document, primitive["attributes"], kBase);
    if (const Json* targets = find(primitive, "targets"))
      for (std::size_t i = 0; i < targets->size(); ++i)
        needed |= !is_core_map(document, (*targets)[i], static_cast<int>(i));
  });
  if (!needed) remove_extension_name(document.json, "KHR_mesh_quantization");
}

}  // namespace deltamesh::gltf
