// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "peers/draco_mesh.h"

#include <draco/compression/decode.h>
#include <draco/compression/encode.h>
#include <draco/core/draco_version.h>

#include <string_view>
#include <utility>

#include "peers/peer.h"
#include "support/errors.h"

namespace deltamesh::bench {
namespace {

constexpr std::string_view kPositionName = "POSITION";

draco::DataType data_type(ComponentType type) {
  constexpr draco::DataType kTypes[] = {draco::DT_INT8,    draco::DT_UINT8,  draco::DT_INT16,
                                        draco::DT_UINT16,  draco::DT_INT32,  draco::DT_UINT32,
                                        draco::DT_FLOAT32, draco::DT_FLOAT64};
  return kTypes[static_cast<std::size_t>(type)];
}

draco::GeometryAttribute::Type draco_type(AttributeKind kind) {
  if (kind == AttributeKind::kNormal) return draco::GeometryAttribute::NORMAL;
  if (kind == AttributeKind::kUv) return draco::GeometryAttribute::TEX_COORD;
  if (kind == AttributeKind::kColor) return draco::GeometryAttribute::COLOR;
  return draco::GeometryAttribute::GENERIC;
}

void add_attribute(draco::Mesh& mesh, draco::GeometryAttribute::Type type, const AttributeView& attribute) {
  const int id = mesh.AddAttribute(layout(type, attribute), true, mesh.num_points());
  set_values(*mesh.attribute(id), attribute, mesh.num_points());
}

}  // namespace

draco::GeometryAttribute layout(draco::GeometryAttribute::Type type, const AttributeView& attribute) {
  draco::GeometryAttribute result;
  result.Init(type, nullptr, static_cast<std::int8_t>(attribute.components), data_type(attribute.type),
              attribute.normalized,
              static_cast<std::int64_t>(attribute.components * component_size(attribute.type)), 0);
  return result;
}

void set_values(draco::PointAttribute& attribute, const AttributeView& view, std::size_t count) {
  const std::size_t size = view.values.size() / count;
  for (std::uint32_t i = 0; i < count; ++i)
    attribute.SetAttributeValue(draco::AttributeValueIndex(i), view.values.data() + i * size);
}

AttributeView position_view(const MeshView& mesh) {
  return {.kind = AttributeKind::kGeneric,
          .type = ComponentType::kF32,
          .components = 3,
          .normalized = false,
          .name = kPositionName,
          .values = std::as_bytes(mesh.positions)};
}

int bits_of(const AttributeView& attribute, const DracoSetting& setting) {
  if (attribute.name == kPositionName) return setting.position_bits;
  if (attribute.kind == AttributeKind::kNormal) return setting.normal_bits;
  if (attribute.kind == AttributeKind::kUv) return setting.uv_bits;
  return attribute.kind == AttributeKind::kColor ? kColorBits : kGenericBits;
}

std::unique_ptr<draco::Mesh> to_draco(const MeshView& mesh, std::optional<std::size_t> left_out) {
  auto result = std::make_unique<draco::Mesh>();
  result->set_num_points(static_cast<std::uint32_t>(mesh.vertex_count()));
  result->SetNumFaces(mesh.triangle_count());
  for (std::uint32_t f = 0; f < mesh.triangle_count(); ++f) {
    const std::uint32_t* corners = mesh.triangles.data() + std::size_t{3} * f;
    result->SetFace(draco::FaceIndex(f), {draco::PointIndex(corners[0]), draco::PointIndex(corners[1]),
                                          draco::PointIndex(corners[2])});
  }
  add_attribute(*result, draco::GeometryAttribute::POSITION, position_view(mesh));
  for (std::size_t a = 0; a < mesh.attributes.size(); ++a)
    if (a != left_out) add_attribute(*result, draco_type(mesh.attributes[a].kind), mesh.attributes[a]);
  return result;
}

Result<std::vector<std::byte>> encode_draco(const draco::Mesh& mesh, const DracoSetting& setting, int level) {
  draco::Encoder encoder;
  encoder.SetSpeedOptions(10 - level, 10 - level);
  encoder.SetAttributeQuantization(draco::GeometryAttribute::POSITION, setting.position_bits);
  encoder.SetAttributeQuantization(draco::GeometryAttribute::NORMAL, setting.normal_bits);
  encoder.SetAttributeQuantization(draco::GeometryAttribute::TEX_COORD, setting.uv_bits);
  encoder.SetAttributeQuantization(draco::GeometryAttribute::COLOR, kColorBits);
  encoder.SetAttributeQuantization(draco::GeometryAttribute::GENERIC, kGenericBits);
  draco::EncoderBuffer buffer;
  if (!encoder.EncodeMeshToBuffer(mesh, &buffer).ok()) return failure("Draco cannot encode the mesh");
  const auto bytes = std::as_bytes(std::span(buffer.data(), buffer.size()));
  return std::vector<std::byte>(bytes.begin(), bytes.end());
}

Result<std::unique_ptr<draco::Mesh>> decode_draco(std::span<const std::byte> bytes) {
  draco::DecoderBuffer buffer;
  buffer.Init(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  draco::Decoder decoder;
  auto mesh = decoder.DecodeMeshFromBuffer(&buffer);
  if (!mesh.ok()) return failure("Draco cannot decode what it encoded");
  return std::move(mesh).value();
}

std::string draco_version() { return draco::kDracoVersion; }

}  // namespace deltamesh::bench
