// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors

#include "attributes/attribute.h"
#include "attributes/colors/colors.h"
#include "attributes/exceptions/exceptions.h"
#include "attributes/models.h"
#include "attributes/normals/normals.h"
#include "attributes/payload.h"
#include "attributes/plain/plain.h"
#include "attributes/rare/rare.h"
#include "attributes/skin/rows.h"
#include "attributes/tangents/tangents.h"
#include "attributes/uvs/uvs.h"
#include "base/byte_reader.h"
#include "base/checked.h"
#include "format/chunk/tags.h"

namespace deltamesh {
namespace {

/// Of a compact payload; the values of `shape`, whose own are not looked at.
Result<std::vector<std::byte>> read_on_surface(ByteReader& in, AttributeCoding coding, const Attribute& shape,
                                               const AttributeSurface& surface,
                                               std::span<const Attribute> others,
                                               const Learning<AttributeModels>& learning,
                                               const Attribute* known) {
  DELTAMESH_TRY(const auto bytes, in.read_bytes(in.remaining()));
  std::vector<float> numbers;
  switch (coding) {
    case AttributeCoding::kSurfaceColors:
      return read_surface_colors(
          bytes, shape.type, shape.components, surface,
          {color_models(learning.start), learning.end != nullptr ? &learning.end->colors.emplace() : nullptr},
          known);
    case AttributeCoding::kSurfaceNormals: {
      DELTAMESH_TRY(numbers, read_surface_normals(bytes, surface));
      break;
    }
    case AttributeCoding::kSurfaceUvs: {
      DELTAMESH_TRY(numbers, read_surface_uvs(bytes, surface));
      break;
    }
    case AttributeCoding::kSurfaceTangents: {
      const TangentBasis basis = tangent_basis(others, surface.vertex_count());
      DELTAMESH_TRY(numbers, read_surface_tangents(bytes, surface, basis));
      break;
    }
    default: {
      const auto joints = coding == AttributeCoding::kWeights
                              ? joints_of_weights(others, surface.vertex_count())
                              : std::vector<JointRow>();
      return read_rare_values(coding, bytes, shape, surface, joints, learning);
    }
  }
  const auto values = std::as_bytes(std::span(numbers));
  return std::vector<std::byte>(values.begin(), values.end());
}

/// The first byte of a payload [ATTR-2].
struct CodingByte {
  AttributeCoding coding;
  bool has_exceptions;  ///< [ATTR-12]
};

/// Which fits the shape of the values.
Result<CodingByte> read_coding(ByteReader& in, const AttributeDescriptor& descriptor) {
  DELTAMESH_TRY(auto byte, in.read<std::uint8_t>());
  const bool has_exceptions = (byte & kExceptionsFlag) != 0;
  if (has_exceptions) byte = static_cast<std::uint8_t>(byte & ~kExceptionsFlag);
  const auto coding = static_cast<AttributeCoding>(byte);
  if (!coding_fits(coding, descriptor.kind, descriptor.type, descriptor.components))
    return in.invalid("attribute coding that its shape does not allow", "ATTR-2");
  return CodingByte{coding, has_exceptions};
}

}  // namespace

Attribute shape_of(const AttributeDescriptor& descriptor) {
  return {.kind = descriptor.kind,
          .type = descriptor.type,
          .components = descriptor.components,
          .normalized = descriptor.is_normalized(),
          .name = descriptor.name,
          .linear = descriptor.is_linear()};
}

std::uint64_t attribute_bytes(const AttributeDescriptor& descriptor, std::uint32_t rows) noexcept {
  return saturating_mul(rows, descriptor.components * component_size(descriptor.type));
}

Result<Attribute> read_attribute(Payload payload, const AttributeDescriptor& descriptor,
                                 const AttributeSurface& surface, std::span<const Attribute> others,
                                 std::uint64_t max_bytes, const Learning<AttributeModels>& learning,
                                 const Attribute* known) {
  ByteReader in(payload.bytes, kTagAttribute);
  if (attribute_bytes(descriptor, surface.vertex_count()) > max_bytes)
    return in.error(ErrorCode::kLimitExceeded, "attribute values larger than allowed", "ATTR-8");
  Attribute attribute = shape_of(descriptor);
  if (!payload.is_compact) {
    DELTAMESH_TRY(attribute.values, read_plain_values(payload.bytes, attribute, surface.vertex_count()));
    return attribute;
  }
  DELTAMESH_TRY(const CodingByte first, read_coding(in, descriptor));
  const std::size_t row_size = descriptor.components * component_size(descriptor.type);
  Exceptions exceptions;
  if (first.has_exceptions) {
    DELTAMESH_TRY(exceptions, read_exceptions(in, row_size, surface.vertex_count()));
  }
  DELTAMESH_TRY(attribute.values,
                read_on_surface(in, first.coding, attribute, surface, others, learning, known));
  put_exceptions(exceptions, row_size, attribute.values);
  return attribute;
}

}  // namespace deltamesh
