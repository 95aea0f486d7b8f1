// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A mesh whose only attribute is its colours.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "deltamesh/mesh.h"

namespace deltamesh::bench {

/// `mesh` with its first 8-bit colours as the only attribute; empty where it has none.
inline std::optional<Mesh> colors_alone(Mesh mesh) {
  std::erase_if(mesh.attributes, [](const Attribute& a) {
    return a.kind != AttributeKind::kColor || a.type != ComponentType::kU8;
  });
  if (mesh.attributes.empty()) return std::nullopt;
  mesh.attributes.resize(1);
  return mesh;
}

}  // namespace deltamesh::bench
