// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "split/assemble.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <unordered_map>

namespace deltamesh {
namespace {

/// Position and attributes of a vertex, as bytes.
std::string row_of(const Mesh& mesh, std::size_t vertex) {
  const auto* position = reinterpret_cast<const char*>(mesh.positions.data() + 3 * vertex);
  std::string row(position, 3 * sizeof(float));
  for (const Attribute& attribute : mesh.attributes) {
    const std::size_t size = attribute.components * component_size(attribute.type);
    row.append(reinterpret_cast<const char*>(attribute.values.data()) + size * vertex, size);
  }
  return row;
}

/// Makes one mesh of several.
class Assembly {
 public:
  explicit Assembly(bool has_groups) : has_groups_(has_groups) {}

  void add(const Mesh& block) {
    if (mesh_.attributes.empty()) {
      mesh_.origin = block.origin;
      for (Attribute attribute : block.attributes) {
        attribute.values.clear();
        mesh_.attributes.push_back(std::move(attribute));
      }
    }
    std::vector<std::uint32_t> numbers;
    for (std::size_t v = 0; v < block.vertex_count(); ++v) numbers.push_back(number_of(block, v));
    for (const std::uint32_t v : block.triangles) mesh_.triangles.push_back(numbers[v]);
    if (!has_groups_) return;
    mesh_.face_groups.insert(mesh_.face_groups.end(), block.face_groups.begin(), block.face_groups.end());
    mesh_.face_groups.resize(mesh_.triangle_count(), 0);
  }
  Mesh take() { return std::move(mesh_); }

 private:
  std::uint32_t number_of(const Mesh& block, std::size_t vertex) {
    const auto next = static_cast<std::uint32_t>(mesh_.vertex_count());
    const auto [found, is_new] = known_.try_emplace(row_of(block, vertex), next);
    if (!is_new) return found->second;
    const float* p = block.positions.data() + 3 * vertex;
    mesh_.positions.insert(mesh_.positions.end(), p, p + 3);
    for (std::size_t i = 0; i < mesh_.attributes.size(); ++i) {
      const Attribute& from = block.attributes[i];
      const std::size_t size = from.components * component_size(from.type);
      const auto value = from.values.begin() + static_cast<std::ptrdiff_t>(size * vertex);
      mesh_.attributes[i].values.insert(mesh_.attributes[i].values.end(), value,
                                        value + static_cast<std::ptrdiff_t>(size));
    }
    return next;
  }

  bool has_groups_;
  Mesh mesh_;
  std::unordered_map<std::string, std::uint32_t> known_;
};

}  // namespace

MapPart assemble(const PartKey& key, std::span<const StoredBlock* const> blocks,
                 std::span<const BorderPosition> border) {
  Assembly assembly(
      std::ranges::any_of(blocks, [](const StoredBlock* block) { return !block->mesh.face_groups.empty(); }));
  for (const StoredBlock* block : blocks) assembly.add(block->mesh);
  MapPart part{key, assembly.take(), {}};
  for (std::size_t v = 0; v < part.mesh.vertex_count(); ++v) {
    const PositionBits position = bits_of(part.mesh, v);
    const auto found = std::ranges::lower_bound(border, position, {}, &BorderPosition::position);
    if (found != border.end() && found->position == position)
      part.border.push_back({static_cast<std::uint32_t>(v), found->point, found->twin});
  }
  return part;
}

}  // namespace deltamesh
