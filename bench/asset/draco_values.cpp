// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "asset/draco_values.h"

#include <draco/attributes/attribute_octahedron_transform.h>
#include <draco/attributes/attribute_quantization_transform.h>

#include <cstring>
#include <set>
#include <string>
#include <utility>

namespace deltamesh::bench {
namespace {

/// `attribute` after a quantiser and its inverse.
template <class Transform>
std::vector<std::byte> round_trip(Transform& transform, const AttributeView& attribute, std::size_t count) {
  draco::PointAttribute source(layout(draco::GeometryAttribute::GENERIC, attribute));
  source.Reset(count);
  source.SetIdentityMapping();
  set_values(source, attribute, count);
  const auto portable = transform.InitTransformedAttribute(source, static_cast<int>(count));
  draco::PointAttribute decoded(layout(draco::GeometryAttribute::GENERIC, attribute));
  decoded.Reset(count);
  decoded.SetIdentityMapping();
  transform.TransformAttribute(source, {}, portable.get());
  transform.InverseTransformAttribute(*portable, &decoded);
  std::vector<std::byte> values(attribute.values.size());
  const std::size_t size = values.size() / count;
  for (std::uint32_t i = 0; i < count; ++i)
    decoded.GetValue(draco::AttributeValueIndex(i), values.data() + i * size);
  return values;
}

std::vector<std::byte> quantized(const AttributeView& attribute, std::size_t count, int bits) {
  draco::PointAttribute source(layout(draco::GeometryAttribute::GENERIC, attribute));
  source.Reset(count);
  set_values(source, attribute, count);
  draco::AttributeQuantizationTransform transform;
  transform.ComputeParameters(source, bits);
  return round_trip(transform, attribute, count);
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

Mesh draco_values(const Primitive& primitive, const DracoSetting& setting) {
  Mesh result = primitive.mesh;
  const std::size_t count = result.vertex_count();
  const auto positions = quantized(position_view(primitive.mesh), count, setting.position_bits);
  std::memcpy(result.positions.data(), positions.data(), positions.size());
  const MeshView view(primitive.mesh);
  for (std::size_t a = 0; a < view.attributes.size(); ++a) {
    const AttributeView& attribute = view.attributes[a];
    const Part part = part_of(attribute.kind, attribute.name);
    if (attribute.type != ComponentType::kF32) continue;
    if (part == Part::kNormals) {
      draco::AttributeOctahedronTransform to_octahedron;
      to_octahedron.SetParameters(setting.normal_bits);
      result.attributes[a].values = round_trip(to_octahedron, attribute, count);
    } else {
      const int bits = part == Part::kUvs      ? setting.uv_bits
                       : part == Part::kColors ? kColorBits
                                               : kGenericBits;
      result.attributes[a].values = quantized(attribute, count, bits);
    }
  }
  return result;
}

bool decodes_to(std::span<const std::byte> stream, const Mesh& values) {
  const auto decoded = decode_draco(stream);
  return decoded && rows_of(**decoded) == rows_of(values);
}

}  // namespace deltamesh::bench
