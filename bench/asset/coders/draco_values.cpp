// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "asset/coders/draco_values.h"

#include <cstring>
#include <set>
#include <string>
#include <utility>

namespace deltamesh::bench {
namespace {

draco::PointAttribute empty_attribute(const AttributeView& attribute, std::size_t count) {
  draco::PointAttribute result(layout(draco::GeometryAttribute::GENERIC, attribute));
  result.Reset(count);
  result.SetIdentityMapping();
  return result;
}

/// `attribute` after its quantiser and the inverse.
std::vector<std::byte> round_trip(const AttributeView& attribute, std::size_t count,
                                  const DracoSetting& setting) {
  draco::PointAttribute decoded = empty_attribute(attribute, count);
  with_quantizer(attribute, count, setting, [&](auto& transform, const draco::PointAttribute& portable) {
    transform.InverseTransformAttribute(portable, &decoded);
  });
  std::vector<std::byte> values(attribute.values.size());
  const std::size_t size = values.size() / count;
  for (std::uint32_t i = 0; i < count; ++i)
    decoded.GetValue(draco::AttributeValueIndex(i), values.data() + i * size);
  return values;
}

/// The bits of all values of every point, each combination once.
using Rows = std::set<std::string>;

Rows rows_of(const Mesh& mesh) {
  Rows rows;
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    std::string row(reinterpret_cast<const char*>(mesh.positions.data() + 3 * v), 3 * sizeof(float));
    for (const Attribute& attribute : mesh.attributes) {
      const std::size_t size = attribute.values.size() / mesh.vertex_count();
      row.append(reinterpret_cast<const char*>(attribute.values.data() + v * size), size);
    }
    rows.insert(std::move(row));
  }
  return rows;
}

/// Attributes in the order in which to_draco() adds them.
Rows rows_of(const draco::Mesh& mesh) {
  Rows rows;
  for (draco::PointIndex point(0); point < mesh.num_points(); ++point) {
    std::string row;
    for (int id = 0; id < mesh.num_attributes(); ++id) {
      const draco::PointAttribute& attribute = *mesh.GetAttributeByUniqueId(static_cast<std::uint32_t>(id));
      const auto* value = attribute.GetAddressOfMappedIndex(point);
      row.append(reinterpret_cast<const char*>(value), static_cast<std::size_t>(attribute.byte_stride()));
    }
    rows.insert(std::move(row));
  }
  return rows;
}

}  // namespace

Mesh draco_values(const Mesh& mesh, const DracoSetting& setting) {
  Mesh result = mesh;
  const std::size_t count = result.vertex_count();
  const auto positions = round_trip(position_view(mesh), count, setting);
  std::memcpy(result.positions.data(), positions.data(), positions.size());
  const MeshView view(mesh);
  for (std::size_t a = 0; a < view.attributes.size(); ++a)
    if (view.attributes[a].type == ComponentType::kF32)
      result.attributes[a].values = round_trip(view.attributes[a], count, setting);
  return result;
}

bool decodes_to(std::span<const std::byte> stream, const Mesh& values) {
  const auto decoded = decode_draco(stream);
  return decoded && rows_of(**decoded) == rows_of(values);
}

}  // namespace deltamesh::bench
