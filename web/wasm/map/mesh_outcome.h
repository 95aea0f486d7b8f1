// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A mesh of a map's part as `map` hands it to JavaScript.
#pragma once

#include <algorithm>
#include <vector>

#include "deltamesh/mesh.h"
#include "outcome.h"

namespace deltamesh::web {

/// Refers to the mesh. Not to be moved once described.
struct MeshOutcome {
  std::vector<AttributeOutcome> attributes;
  StreamOutcome outcome;

  void describe(const Mesh& mesh) {
    for (const Attribute& attribute : mesh.attributes) attributes.push_back(outcome_of(attribute));
    std::copy_n(mesh.origin.data(), 3, outcome.origin);
    outcome.vertices = static_cast<std::uint32_t>(mesh.positions.size() / 3);
    outcome.triangles = static_cast<std::uint32_t>(mesh.triangles.size() / 3);
    outcome.attribute_count = static_cast<std::uint32_t>(attributes.size());
    outcome.attributes = attributes.data();
    outcome.positions = mesh.positions.data();
    outcome.indices = mesh.triangles.data();
    outcome.groups = mesh.face_groups.empty() ? nullptr : mesh.face_groups.data();
  }

 private:
  static AttributeOutcome outcome_of(const Attribute& attribute) {
    return {.name = attribute.name.data(),
            .name_bytes = static_cast<std::uint32_t>(attribute.name.size()),
            .kind = static_cast<std::uint32_t>(attribute.kind),
            .type = static_cast<std::uint32_t>(attribute.type),
            .components = attribute.components,
            .flags = (attribute.normalized ? 1U : 0U) | (attribute.linear ? 2U : 0U),
            .values = attribute.values.data()};
  }
};

}  // namespace deltamesh::web
