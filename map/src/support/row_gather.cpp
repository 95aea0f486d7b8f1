// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "support/row_gather.h"

#include <limits>
#include <string>
#include <utility>

namespace deltamesh {
namespace {

constexpr std::uint32_t kNoRow = std::numeric_limits<std::uint32_t>::max();

}  // namespace

RowGather::RowGather(MeshView source) : source_(std::move(source)), number_(source_.vertex_count(), kNoRow) {}

void RowGather::add_face(std::size_t face) {
  for (std::size_t c = 0; c < 3; ++c) {
    const std::uint32_t vertex = source_.triangles[3 * face + c];
    if (number_[vertex] == kNoRow) {
      number_[vertex] = static_cast<std::uint32_t>(rows_.size());
      rows_.push_back(vertex);
    }
    triangles_.push_back(number_[vertex]);
  }
  if (!source_.face_groups.empty()) groups_.push_back(source_.face_groups[face]);
}

Mesh RowGather::take() {
  Mesh mesh;
  mesh.origin = source_.origin;
  mesh.positions.reserve(3 * rows_.size());
  for (const std::uint32_t row : rows_) {
    const auto position = source_.positions.subspan(3 * std::size_t{row}, 3);
    mesh.positions.insert(mesh.positions.end(), position.begin(), position.end());
    number_[row] = kNoRow;
  }
  for (const AttributeView& view : source_.attributes) {
    Attribute attribute{.kind = view.kind,
                        .type = view.type,
                        .components = view.components,
                        .normalized = view.normalized,
                        .name = std::string(view.name),
                        .linear = view.linear};
    const std::size_t size = view.components * component_size(view.type);
    attribute.values.reserve(size * rows_.size());
    for (const std::uint32_t row : rows_) {
      const auto value = view.values.subspan(size * row, size);
      attribute.values.insert(attribute.values.end(), value.begin(), value.end());
    }
    mesh.attributes.push_back(std::move(attribute));
  }
  mesh.triangles = std::exchange(triangles_, {});
  mesh.face_groups = std::exchange(groups_, {});
  rows_.clear();
  return mesh;
}

}  // namespace deltamesh
