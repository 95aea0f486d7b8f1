// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors

#include "base/try.h"
#include "entropy/coder/reader.h"
#include "patch/coder.h"
#include "patch/payload.h"
#include "support/errors.h"

namespace deltamesh {
namespace {

/// Appends vertices of `from` to `to`, which has the same attributes.
void append_rows(const Mesh& from, std::span<const std::uint32_t> rows, Mesh& to) {
  for (const std::uint32_t row : rows) {
    const auto position = from.positions.begin() + static_cast<std::ptrdiff_t>(3 * std::size_t{row});
    to.positions.insert(to.positions.end(), position, position + 3);
  }
  for (std::size_t i = 0; i < from.attributes.size(); ++i) {
    const Attribute& source = from.attributes[i];
    const auto size = static_cast<std::ptrdiff_t>(source.components * component_size(source.type));
    auto& values = to.attributes[i].values;
    for (const std::uint32_t row : rows) {
      const auto value = source.values.begin() + size * static_cast<std::ptrdiff_t>(row);
      values.insert(values.end(), value, value + size);
    }
  }
}

void append_border(std::span<const BorderVertex> border, std::span<const std::uint32_t> numbers,
                   std::uint32_t least, std::vector<BorderVertex>& to) {
  for (BorderVertex vertex : border) {
    vertex.vertex = numbers[vertex.vertex];
    if (vertex.vertex != kNotJoined && vertex.vertex >= least) to.push_back(vertex);
  }
}

}  // namespace

std::vector<std::uint32_t> staying_triangles(const Mesh& base, const std::vector<std::uint8_t>& stays) {
  std::vector<std::uint32_t> triangles;
  for (std::size_t face = 0; face < stays.size(); ++face)
    for (std::size_t c = 0; stays[face] != 0 && c < 3; ++c) triangles.push_back(base.triangles[3 * face + c]);
  return triangles;
}

Result<PatchPlan> read_patch_plan(std::span<const std::byte> bytes, const Mesh& base, const Mesh& inserted) {
  CompactReader reader(bytes);
  PatchModels models;
  PatchPlan plan;
  code_staying(reader, models, base, plan.stays);
  const auto staying = staying_triangles(base, plan.stays);
  if (!JoinCoder(reader, models, base, staying, inserted).code(plan.joins) && !reader.failed())
    return broken_patch("a vertex joined to what is no free vertex of the base");
  DELTAMESH_CHECK(reader.finish(0));
  if (staying.empty()) return broken_patch("a patch of a base of which no face stays");
  return plan;
}

std::vector<std::uint32_t> staying_vertices(const Mesh& base, const PatchPlan& plan) {
  std::vector<std::uint8_t> is_used(base.vertex_count(), 0);
  for (const std::uint32_t v : staying_triangles(base, plan.stays)) is_used[v] = 1;
  std::vector<std::uint32_t> vertices;
  for (std::uint32_t v = 0; v < is_used.size(); ++v)
    if (is_used[v] != 0) vertices.push_back(v);
  return vertices;
}

MapPart put_together(const PartKey& key, const MapPart& base, const MapPart& inserted,
                     const PatchPlan& plan) {
  MapPart part;
  part.key = key;
  part.mesh.origin = base.mesh.origin;
  part.mesh.attributes = base.mesh.attributes;
  for (Attribute& attribute : part.mesh.attributes) attribute.values.clear();

  const auto kept = staying_vertices(base.mesh, plan);
  std::vector<std::uint32_t> numbers(base.mesh.vertex_count(), kNotJoined);
  for (std::size_t i = 0; i < kept.size(); ++i) numbers[kept[i]] = static_cast<std::uint32_t>(i);
  append_rows(base.mesh, kept, part.mesh);
  for (const std::uint32_t v : staying_triangles(base.mesh, plan.stays))
    part.mesh.triangles.push_back(numbers[v]);
  append_border(base.border, numbers, 0, part.border);

  const auto first = static_cast<std::uint32_t>(kept.size());
  std::uint32_t next = first;
  std::vector<std::uint32_t> rows;
  std::vector<std::uint32_t> inserted_numbers;
  for (std::uint32_t v = 0; v < inserted.mesh.vertex_count(); ++v) {
    const bool is_joined = plan.joins[v] != kNotJoined;
    inserted_numbers.push_back(is_joined ? numbers[plan.joins[v]] : next++);
    if (!is_joined) rows.push_back(v);
  }
  append_rows(inserted.mesh, rows, part.mesh);
  for (const std::uint32_t v : inserted.mesh.triangles) part.mesh.triangles.push_back(inserted_numbers[v]);
  append_border(inserted.border, inserted_numbers, first, part.border);
  return part;
}

}  // namespace deltamesh
