// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>
#include <optional>
#include <string>

#include "attributes/attribute.h"
#include "attributes/colors/colors.h"
#include "attributes/error.h"
#include "attributes/lattice/lattice.h"
#include "attributes/normals/normals.h"
#include "attributes/payload.h"
#include "attributes/plain/plain.h"
#include "attributes/rows.h"
#include "attributes/skin/skin.h"
#include "attributes/tangents/tangents.h"
#include "attributes/uvs/uvs.h"
#include "attributes/values.h"
#include "base/byte_writer.h"
#include "base/component.h"
#include "base/numbers/short_float.h"
#include "base/try.h"

namespace deltamesh {
namespace {

Error sizes_disagree(const char* message) { return {.code = ErrorCode::kInvalidMesh, .message = message}; }

Result<void> check_shape(const AttributeView& attribute, std::span<const std::uint32_t> order) {
  if (attribute.components == 0 || attribute.components > kMaxComponents)
    return sizes_disagree("an attribute has no component or too many");
  if (attribute.name.size() > kMaxAttributeName) return sizes_disagree("an attribute's name is too long");
  const std::size_t row = attribute.components * component_size(attribute.type);
  if (attribute.values.size() % row != 0)
    return sizes_disagree("an attribute's values are not whole vertices");
  const std::size_t rows = attribute.values.size() / row;
  if (std::any_of(order.begin(), order.end(), [rows](std::uint32_t vertex) { return vertex >= rows; }))
    return sizes_disagree("an attribute has fewer values than the mesh has vertices");
  return {};
}

/// The largest error that a descriptor can tell; larger bounds are cut to it.
constexpr double kLargestBound = 0x1p127;

/// The bound on the error of `attribute`; 0: exact.
double bound_of(const AttributeView& attribute, const AttributeQuality& quality) noexcept {
  switch (attribute.kind) {
    case AttributeKind::kNormal:
      return quality.normal_error;
    case AttributeKind::kTangent:
      return quality.tangent_error.value_or(quality.normal_error);
    case AttributeKind::kUv:
      return quality.uv_error;
    case AttributeKind::kColor:
      return quality.color_error;
    case AttributeKind::kWeights:
      return quality.weight_error;
    case AttributeKind::kJoints:
      return 0;
    case AttributeKind::kGeneric:
      break;
  }
  for (const NamedBound& named : quality.named)
    if (named.name == attribute.name) return named.error;
  return 0;
}

/// The compact payload of a coding, which has no plain form, and values; empty where the coding does not keep
/// the bound.
template <class T>
std::optional<CodedAttribute> code_compact(AttributeCoding coding,
                                           const std::optional<CodedValues<T>>& values) {
  if (!values) return std::nullopt;
  ByteWriter out;
  out.write(static_cast<std::uint8_t>(coding));
  out.write_bytes(values->bytes);
  CodedAttribute coded;
  coded.compact = out.take();
  const auto decoded = std::as_bytes(std::span(values->values));
  coded.decoded.values.assign(decoded.begin(), decoded.end());
  return coded;
}

std::optional<CodedAttribute> code_on_lattices(const AttributeView& attribute, const AttributeRows& rows,
                                               double bound, int effort, const AttributeSurface& surface) {
  return code_compact(AttributeCoding::kLattice, write_lattice(attribute, rows, bound, effort, surface));
}

/// By the coding of the attribute's kind and shape; empty where there is none, or none that keeps the bound.
std::optional<CodedAttribute> code_kind(const AttributeView& attribute, const AttributeRows& rows,
                                        double bound, const AttributeSettings& settings,
                                        const AttributeSurface& surface, std::span<const Attribute> others) {
  using enum AttributeCoding;
  const auto fits = [&](AttributeCoding coding) {
    return coding_fits(coding, attribute.kind, attribute.type, attribute.components);
  };
  if (fits(kSurfaceNormals))
    return code_compact(kSurfaceNormals, write_surface_normals(rows.gather_floats(), bound, surface));
  if (fits(kSurfaceUvs))
    return code_compact(kSurfaceUvs, write_surface_uvs(rows.gather_floats(), bound, surface));
  if (fits(kSurfaceTangents)) {
    const TangentBasis basis = tangent_basis(others, surface.vertex_count());
    return code_compact(kSurfaceTangents,
                        write_surface_tangents(rows.gather_floats(), bound, surface, basis));
  }
  if (fits(kSurfaceColors))
    return code_compact(kSurfaceColors,
                        write_surface_colors(attribute.type, rows, bound, surface, settings.start));
  if (fits(kJoints)) return code_compact(kJoints, std::optional(write_joints(attribute, rows, surface)));
  if (fits(kWeights)) {
    auto coded = code_compact(kWeights, write_weights(attribute, rows, bound, surface, others));
    if (coded) return coded;
  }
  switch (attribute.kind) {
    case AttributeKind::kGeneric:
    case AttributeKind::kJoints:
      return code_on_lattices(attribute, rows, bound, settings.effort, surface);
    case AttributeKind::kWeights:
      return code_on_lattices(attribute, rows, bound * normalized_one(attribute.type), settings.effort,
                              surface);
    default:
      return std::nullopt;
  }
}

/// Empty where no coding of the surface suits the attribute.
std::optional<CodedAttribute> write_on_surface(const AttributeView& attribute, const AttributeRows& rows,
                                               double bound, const AttributeSettings& settings,
                                               const AttributeSurface& surface,
                                               std::span<const Attribute> others) {
  auto coded = code_kind(attribute, rows, bound, settings, surface, others);
  if (!coded) coded = code_on_lattices(attribute, rows, 0, settings.effort, surface);
  // Exact wide values may repeat in a way that only the plain form's codec finds, as in copies of parts.
  const bool is_wide = component_size(attribute.type) >= 4;
  if (coded && is_wide && settings.effort > 0 && coded->decoded.values == rows.gather())
    coded->plain = write_exact_attribute(attribute, rows);
  return coded;
}

AttributeDescriptor describe(const AttributeView& attribute) {
  return {.kind = attribute.kind,
          .type = attribute.type,
          .components = attribute.components,
          .flags = static_cast<std::uint8_t>(attribute.normalized ? 1 : 0),
          .name = std::string(attribute.name)};
}

}  // namespace

Result<CodedAttribute> write_attribute(const AttributeView& attribute, std::span<const std::uint32_t> order,
                                       const AttributeSettings& settings, const AttributeSurface& surface,
                                       std::span<const Attribute> others) {
  DELTAMESH_CHECK(check_shape(attribute, order));
  const AttributeRows rows(attribute, order);
  const double bound = std::min(bound_of(attribute, settings.quality), kLargestBound);
  std::optional<CodedAttribute> coded;
  if (!settings.plain) coded = write_on_surface(attribute, rows, bound, settings, surface, others);
  const AttributeDescriptor descriptor = describe(attribute);
  Attribute decoded = shape_of(descriptor);
  if (coded) {
    decoded.values = std::move(coded->decoded.values);
  } else {
    coded.emplace().plain = write_plain_attribute(attribute, rows, bound);
    DELTAMESH_TRY(decoded.values, read_plain_values(coded->plain, decoded, surface.vertex_count()));
  }
  coded->decoded = std::move(decoded);
  coded->descriptor = descriptor;
  coded->descriptor.error = short_float_above(attribute_error(attribute, rows, coded->decoded.values));
  return *std::move(coded);
}

}  // namespace deltamesh
