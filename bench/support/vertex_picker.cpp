// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "support/vertex_picker.h"

namespace deltamesh::bench {
namespace {

std::span<const std::byte> value_of(const Attribute& attribute, std::uint32_t vertex) {
  const std::size_t size = attribute.components * component_size(attribute.type);
  return std::span(attribute.values).subspan(size * vertex, size);
}

}  // namespace

std::string position_bits(const Mesh& mesh, std::uint32_t vertex) {
  const float* position = mesh.positions.data() + std::size_t{3} * vertex;
  return {reinterpret_cast<const char*>(position), 3 * sizeof(float)};
}

std::string vertex_bits(const Mesh& mesh, std::uint32_t vertex) {
  std::string bits = position_bits(mesh, vertex);
  for (const Attribute& attribute : mesh.attributes) {
    const auto value = value_of(attribute, vertex);
    bits.append(reinterpret_cast<const char*>(value.data()), value.size());
  }
  return bits;
}

VertexPicker::VertexPicker(const Mesh& mesh, bool welds) : mesh_(&mesh), welds_(welds) {
  picked_.origin = mesh.origin;
  for (const Attribute& attribute : mesh.attributes)
    picked_.attributes.push_back({.kind = attribute.kind,
                                  .type = attribute.type,
                                  .components = attribute.components,
                                  .normalized = attribute.normalized,
                                  .name = attribute.name,
                                  .values = {},
                                  .linear = attribute.linear});
}

void VertexPicker::add_corner(std::uint32_t vertex) {
  const auto next = static_cast<std::uint32_t>(picked_.vertex_count());
  const auto [known, is_first] = numbers_.try_emplace(vertex, next);
  if (is_first && welds_)
    known->second = numbers_of_bits_.try_emplace(vertex_bits(*mesh_, vertex), next).first->second;
  picked_.triangles.push_back(known->second);
  if (!is_first || known->second != next) return;
  const float* position = mesh_->positions.data() + std::size_t{3} * vertex;
  picked_.positions.insert(picked_.positions.end(), position, position + 3);
  for (std::size_t a = 0; a < picked_.attributes.size(); ++a) {
    const auto value = value_of(mesh_->attributes[a], vertex);
    auto& values = picked_.attributes[a].values;
    values.insert(values.end(), value.begin(), value.end());
  }
}

}  // namespace deltamesh::bench
