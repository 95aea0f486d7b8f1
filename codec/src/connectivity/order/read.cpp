// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>

#include "base/broken_rule.h"
#include "base/memory/large_vector.h"
#include "base/small_code.h"
#include "base/try.h"
#include "connectivity/order/coder.h"
#include "connectivity/order/order.h"
#include "entropy/coder/reader.h"
#include "format/chunk/tags.h"

namespace deltamesh {
namespace {

/// Moves row i of `values`, `row` numbers long, to row `places[i]`.
template <class T>
std::vector<T> scatter_rows(const std::vector<T>& values, const std::vector<std::uint32_t>& places,
                            std::size_t row) {
  std::vector<T> scattered;
  reserve_large(scattered, values.size());
  scattered.resize(values.size());
  for (std::size_t i = 0; i < places.size(); ++i)
    std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(i * row), row,
                scattered.begin() + static_cast<std::ptrdiff_t>(places[i] * row));
  return scattered;
}

}  // namespace

Result<MeshOrder> read_order(std::span<const std::byte> payload, std::span<const std::uint32_t> triangles,
                             std::uint32_t vertex_count) {
  const std::size_t face_count = triangles.size() / 3;
  MeshOrder order{std::vector<std::uint32_t>(vertex_count), std::vector<std::uint32_t>(face_count),
                  std::vector<std::uint8_t>(face_count)};
  CompactReader reader(payload);
  const char* const broken = OrderCoder<CompactReader>(reader, triangles, vertex_count).code(order);
  if (reader.failed() || broken == nullptr) DELTAMESH_CHECK(reader.finish(kTagOrder));
  if (broken != nullptr) return broken_rule("not a permutation, or a rotation beyond 2", broken, kTagOrder);
  return order;
}

Mesh restore_order(const Mesh& mesh, const MeshOrder& order) {
  Mesh restored;
  restored.origin = mesh.origin;
  if constexpr (!kSmallCode) restored.group_names = mesh.group_names;
  restored.positions = scatter_rows(mesh.positions, order.vertices, 3);
  reserve_large(restored.triangles, mesh.triangles.size());
  restored.triangles.resize(mesh.triangles.size());
  for (std::size_t f = 0; f < order.faces.size(); ++f) {
    for (std::size_t corner = 0; corner < 3; ++corner)
      restored.triangles[3 * std::size_t{order.faces[f]} + (order.rotation[f] + corner) % 3] =
          order.vertices[mesh.triangles[3 * f + corner]];
  }
  if (!mesh.face_groups.empty()) restored.face_groups = scatter_rows(mesh.face_groups, order.faces, 1);
  for (const Attribute& attribute : mesh.attributes) {
    Attribute moved = attribute;
    moved.values =
        scatter_rows(attribute.values, order.vertices, attribute.components * component_size(attribute.type));
    restored.attributes.push_back(std::move(moved));
  }
  return restored;
}

}  // namespace deltamesh
