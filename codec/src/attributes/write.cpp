// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "attributes/attribute.h"
#include "attributes/colors/colors.h"
#include "attributes/error.h"
#include "attributes/exceptions/exceptions.h"
#include "attributes/haar/haar.h"
#include "attributes/lattice/lattice.h"
#include "attributes/models.h"
#include "attributes/normals/normals.h"
#include "attributes/payload.h"
#include "attributes/plain/plain.h"
#include "attributes/rows.h"
#include "attributes/skin/skin.h"
#include "attributes/tangents/tangents.h"
#include "attributes/uvs/uvs.h"
#include "attributes/values.h"
#include "base/byte_writer.h"
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

/// The compact payload of one coding, with what decoders get from it. Empty where `values` are: the coding
/// does not keep what is asked for.
template <class T>
std::optional<CodedAttribute> code_compact(AttributeCoding coding,
                                           const std::optional<CodedValues<T>>& values) {
  if (!values) return std::nullopt;
  ByteWriter out;
  out.write(static_cast<std::uint8_t>(coding));
  out.write_bytes(values->bytes);
  CodedAttribute coded;
  coded.payload = out.take();
  coded.is_compact = true;
  const auto decoded = std::as_bytes(std::span(values->values));
  coded.decoded.values.assign(decoded.begin(), decoded.end());
  return coded;
}

std::optional<CodedAttribute> code_on_lattices(const AttributeView& attribute, const AttributeRows& rows,
                                               double bound, int effort, const AttributeSurface& surface) {
  return code_compact(AttributeCoding::kLattice, write_lattice(attribute, rows, bound, effort, surface));
}

/// At a mean error: by the transform, or within a largest error that keeps `rms` where that is smaller.
/// `rms`: of mean_bound_of(). Empty where neither keeps it.
std::optional<CodedAttribute> code_at_mean_error(const AttributeView& attribute, const AttributeRows& rows,
                                                 double rms, const AttributeSettings& settings,
                                                 const AttributeSurface& surface) {
  using enum AttributeCoding;
  const ComponentType type = attribute.type;
  std::optional<CodedAttribute> bounded;
  if (attribute.kind == AttributeKind::kColor) {
    // Errors are evenly spread over the whole numbers from -L to L.
    const double largest = std::floor(std::sqrt(0.25 + 3 * rms * rms) - 0.5);
    // Unchanged colours have their former errors. The mean of these was within the bound; single ones exceed
    // it.
    for (const double former : {3 * rms, 2 * rms, 0.0}) {
      bounded = code_compact(kSurfaceColors,
                             write_surface_colors(type, rows, largest, surface, color_models(settings.start),
                                                  settings.known, former));
      if (!surface.has_known() || !bounded || bounded_rms(type, rows, bounded->decoded.values) <= rms) break;
    }
  } else {
    // Errors are evenly spread over all numbers from -L to L.
    const double largest = std::sqrt(3.0) * rms;
    bounded = code_on_lattices(attribute, rows, largest, settings.effort, surface);
  }
  auto mean = code_compact(
      kMean, write_haar_values(type, rows, rms, surface, mean_models(settings.start), settings.about));
  if (bounded && !(bounded_rms(type, rows, bounded->decoded.values) <= rms)) bounded.reset();
  const bool is_smaller = mean && bounded && bounded->payload.size() <= mean->payload.size();
  return mean && !is_smaller ? std::move(mean) : std::move(bounded);
}

/// By the coding of the attribute's kind and shape; empty where there is none, or none that keeps the bound.
std::optional<CodedAttribute> code_kind(const AttributeView& attribute, const AttributeRows& rows,
                                        double bound, const AttributeSettings& settings,
                                        const AttributeSurface& surface, std::span<const Attribute> others) {
  using enum AttributeCoding;
  const auto fits = [&](AttributeCoding coding) {
    return coding_fits(coding, attribute.kind, attribute.type, attribute.components);
  };
  if (const std::optional<double> rms = mean_bound_of(attribute, settings.quality)) {
    auto coded = code_at_mean_error(attribute, rows, *rms, settings, surface);
    if (coded) return coded;
  }
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
    return code_compact(kSurfaceColors, write_surface_colors(attribute.type, rows, bound, surface,
                                                             color_models(settings.start), settings.known));
  if (fits(kJoints)) return code_compact(kJoints, std::optional(write_joints(attribute, rows, surface)));
  if (fits(kWeights)) return code_compact(kWeights, write_weights(attribute, rows, bound, surface, others));
  if (attribute.kind != AttributeKind::kGeneric && attribute.kind != AttributeKind::kJoints)
    return std::nullopt;
  return code_on_lattices(attribute, rows, bound, settings.effort, surface);
}

/// With the values that no coding holds beside [ATTR-12]; empty where there are none, or too many.
std::optional<CodedAttribute> code_with_exceptions(const AttributeView& attribute, const AttributeRows& rows,
                                                   double bound, const AttributeSettings& settings,
                                                   const AttributeSurface& surface,
                                                   std::span<const Attribute> others) {
  const Exceptions exceptions = find_exceptions(attribute, rows, bound);
  if (exceptions.empty()) return std::nullopt;
  const std::size_t row_size = attribute.components * component_size(attribute.type);
  const std::vector<std::byte> values = without_exceptions(rows, row_size, exceptions);
  AttributeView rest = attribute;
  rest.values = values;
  std::vector<std::uint32_t> order(rows.count());
  std::iota(order.begin(), order.end(), 0U);
  const AttributeRows rest_rows(rest, order);
  auto coded = code_kind(rest, rest_rows, bound, settings, surface, others);
  if (!coded) coded = code_on_lattices(rest, rest_rows, 0, settings.effort, surface);
  if (!coded) return std::nullopt;
  ByteWriter out;
  out.write(static_cast<std::uint8_t>(static_cast<std::uint8_t>(coded->payload[0]) | kExceptionsFlag));
  write_exceptions(out, exceptions, row_size);
  out.write_bytes(std::span(coded->payload).subspan(1));
  coded->payload = out.take();
  put_exceptions(exceptions, row_size, coded->decoded.values);
  return coded;
}

/// Empty where no coding of the surface suits the attribute.
std::optional<CodedAttribute> write_on_surface(const AttributeView& attribute, const AttributeRows& rows,
                                               double bound, const AttributeSettings& settings,
                                               const AttributeSurface& surface,
                                               std::span<const Attribute> others) {
  auto coded = code_kind(attribute, rows, bound, settings, surface, others);
  if (!coded) coded = code_with_exceptions(attribute, rows, bound, settings, surface, others);
  // What a coding of the attribute's kind cannot keep: exactly. Within a bound weights of several sets would
  // no longer add up to 1.
  if (!coded) coded = code_on_lattices(attribute, rows, 0, settings.effort, surface);
  // Exact wide values may repeat in a way that only zstd finds, as in copies of parts. In large arrays it
  // never won.
  constexpr std::size_t kMostBytes = 1U << 16;
  const bool is_wide = component_size(attribute.type) >= 4;
  if (coded && is_wide && settings.effort > 0 && coded->decoded.values.size() < kMostBytes &&
      coded->decoded.values == rows.gather())
    coded->plain = write_plain_attribute(attribute, rows, 0);
  return coded;
}

}  // namespace

Result<CodedAttribute> write_attribute(const AttributeView& attribute, std::span<const std::uint32_t> order,
                                       const AttributeSettings& settings, const AttributeSurface& surface,
                                       std::span<const Attribute> others) {
  DELTAMESH_CHECK(check_shape(attribute, order));
  const AttributeRows rows(attribute, order);
  const double bound = bound_of(attribute, settings.quality);
  std::optional<CodedAttribute> coded;
  if (!settings.plain) coded = write_on_surface(attribute, rows, bound, settings, surface, others);
  const AttributeDescriptor descriptor = descriptor_of(attribute);
  Attribute decoded = shape_of(descriptor);
  if (coded) {
    decoded.values = std::move(coded->decoded.values);
  } else {
    coded.emplace().payload = write_plain_attribute(attribute, rows, bound);
    DELTAMESH_TRY(decoded.values, read_plain_values(coded->payload, decoded, surface.vertex_count()));
  }
  coded->decoded = std::move(decoded);
  coded->descriptor = descriptor;
  if (mean_bound_of(attribute, settings.quality))
    coded->descriptor.rms = short_float_above(attribute_rms(attribute, rows, coded->decoded.values));
  coded->descriptor.error = short_float_above(attribute_error(attribute, rows, coded->decoded.values));
  return *std::move(coded);
}

}  // namespace deltamesh
