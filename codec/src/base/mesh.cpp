// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "deltamesh/mesh.h"

namespace deltamesh {

MeshView::MeshView(const Mesh& mesh)
    : origin(mesh.origin),
      positions(mesh.positions),
      triangles(mesh.triangles),
      face_groups(mesh.face_groups),
      group_names(mesh.group_names) {
  attributes.reserve(mesh.attributes.size());
  for (const Attribute& a : mesh.attributes)
    attributes.push_back({a.kind, a.type, a.components, a.normalized, a.name, a.values, a.linear});
}

}  // namespace deltamesh
