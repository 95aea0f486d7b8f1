// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "primitive_plan.h"

#include <algorithm>
#include <span>
#include <utility>

#include "accessor.h"
#include "base/try.h"
#include "deltamesh/decode.h"
#include "references.h"
#include "structure.h"

namespace deltamesh::gltf {
namespace {

constexpr std::uint64_t kTriangleList = 4;
constexpr std::size_t kMaxAttributes = DecodeLimits{}.attributes;

bool has_extension(const Json& primitive, const char* name) noexcept {
  const Json* extensions = find(primitive, "extensions");
  return extensions && extensions->contains(name);
}

bool has_unknown_extension(const Json& object) {
  const Json* extensions = find(object, "extensions");
  if (!extensions || !extensions->is_object()) return false;
  for (auto item = extensions->begin(); item != extensions->end(); ++item)
    if (!is_harmless_extension(item.key())) return true;
  return false;
}

bool is_index_type(const AccessorShape& shape) noexcept {
  return shape.components == 1 && (shape.type == ComponentType::kU8 || shape.type == ComponentType::kU16 ||
                                   shape.type == ComponentType::kU32);
}

/// Fills `source` with what can be coded. Errors: kInvalidFile.
Result<void> plan_attributes(const Document& document, const Json& primitive, std::uint64_t vertices,
                             std::size_t number, StreamSource& source) {
  const Json& attributes = primitive["attributes"];
  for (auto item = attributes.begin(); item != attributes.end(); ++item) {
    if (item.key() == "POSITION") continue;
    const auto accessor = item->get<std::size_t>();
    DELTAMESH_TRY(const auto rows, read_accessor(document, accessor));
    if (!rows || source.attributes.size() == kMaxAttributes) {
      source.exact_order = true;
      continue;
    }
    if (rows->shape().count != vertices)
      return element_error("the primitive's attributes differ in count", number);
    source.attributes.push_back({item.key(), accessor});
  }
  return {};
}

/// The plan of one primitive; nothing, and a count in the report, where it is left as it is.
Result<std::optional<PrimitivePlan>> plan_primitive(const Document& document, const Json& primitive,
                                                    std::size_t number, GltfReport& report) {
  const auto leave = [](std::uint64_t& reason) {
    ++reason;
    return std::optional<PrimitivePlan>();
  };
  const Error bad_mode = element_error("the primitive's mode is malformed", number);
  DELTAMESH_TRY(const auto mode, unsigned_member(primitive, "mode", kTriangleList, 6, bad_mode));
  const Json* position = find(primitive["attributes"], "POSITION");
  if (mode != kTriangleList || !position) return leave(report.not_triangles);
  if (has_extension(primitive, kExtensionName) || has_extension(primitive, "KHR_draco_mesh_compression"))
    return leave(report.otherwise_compressed);

  PrimitivePlan plan{.number = number, .source = {}};
  StreamSource& source = plan.source;
  source.position = position->get<std::size_t>();
  DELTAMESH_TRY(const auto shape, accessor_shape(document, source.position));
  if (!shape || shape->type != ComponentType::kF32 || shape->components != 3)
    return leave(report.not_float_positions);
  DELTAMESH_TRY(const auto rows, read_accessor(document, source.position));
  if (!rows) return leave(report.otherwise_compressed);
  std::uint64_t corners = shape->count;
  if (const Json* indices = find(primitive, "indices")) {
    source.indices = indices->get<std::size_t>();
    DELTAMESH_TRY(const auto index_rows, read_accessor(document, *source.indices));
    if (!index_rows) return leave(report.otherwise_compressed);
    if (!is_index_type(index_rows->shape()))
      return element_error("the primitive's indices are not unsigned integers", number);
    corners = index_rows->shape().count;
  }
  if (corners < 3) return leave(report.not_triangles);
  source.exact_order = array_size(primitive, "targets") != 0 || has_unknown_extension(primitive);
  DELTAMESH_CHECK(plan_attributes(document, primitive, shape->count, number, source));
  return std::optional(std::move(plan));
}

Result<AccessorRows> required_rows(const Document& document, std::size_t accessor) {
  DELTAMESH_TRY(auto rows, read_accessor(document, accessor));
  DELTAMESH_ENSURE(rows.has_value());
  return *std::move(rows);
}

/// Corners of whole triangles, as vertex numbers of the source.
Result<std::vector<std::uint32_t>> read_corners(const Document& document, const StreamSource& source,
                                                std::uint64_t vertices, std::size_t number) {
  std::vector<std::uint32_t> corners;
  if (!source.indices) {
    corners.resize(static_cast<std::size_t>(vertices / 3 * 3));
    for (std::size_t i = 0; i < corners.size(); ++i) corners[i] = static_cast<std::uint32_t>(i);
    return corners;
  }
  DELTAMESH_TRY(const auto rows, required_rows(document, *source.indices));
  corners.resize(static_cast<std::size_t>(rows.shape().count / 3 * 3));
  for (std::size_t i = 0; i < corners.size(); ++i) {
    corners[i] = read_index(rows.row(i));
    if (corners[i] >= vertices)
      return element_error("a vertex index beyond the primitive's vertices", number);
  }
  return corners;
}

/// The source's vertex for every vertex of the mesh, ascending; `corners` become numbers of the mesh.
std::vector<std::uint32_t> select_vertices(std::vector<std::uint32_t>& corners, std::uint64_t vertices,
                                           bool keep_all) {
  std::vector<std::uint32_t> new_number(static_cast<std::size_t>(vertices), keep_all ? 1 : 0);
  for (const std::uint32_t corner : corners) new_number[corner] = 1;
  std::vector<std::uint32_t> selected;
  for (std::size_t i = 0; i < new_number.size(); ++i) {
    if (new_number[i] == 0) continue;
    new_number[i] = static_cast<std::uint32_t>(selected.size());
    selected.push_back(static_cast<std::uint32_t>(i));
  }
  for (std::uint32_t& corner : corners) corner = new_number[corner];
  return selected;
}

std::vector<std::byte> gather(const AccessorRows& rows, const std::vector<std::uint32_t>& selected) {
  std::vector<std::byte> packed;
  packed.reserve(selected.size() * rows.shape().row_size());
  for (const std::uint32_t i : selected) {
    const auto row = rows.row(i);
    packed.insert(packed.end(), row.begin(), row.end());
  }
  return packed;
}

AttributeKind kind_of(const std::string& semantic, const AccessorShape& shape) noexcept {
  const bool floats = shape.type == ComponentType::kF32;
  if (semantic == "NORMAL" && floats && shape.components == 3) return AttributeKind::kNormal;
  if (semantic.starts_with("TEXCOORD_") && floats && shape.components == 2) return AttributeKind::kUv;
  const bool integers =
      shape.normalized && (shape.type == ComponentType::kU8 || shape.type == ComponentType::kU16);
  if (semantic.starts_with("COLOR_") && (floats || integers) && shape.components >= 3)
    return AttributeKind::kColor;
  return AttributeKind::kGeneric;
}

}  // namespace

Result<std::vector<PrimitivePlan>> plan_primitives(const Document& document, GltfReport& report) {
  std::vector<PrimitivePlan> plans;
  Result<void> result;
  for_each_primitive(document.json, [&](const Json& primitive, std::size_t number) {
    if (!result) return;
    ++report.primitives;
    auto plan = plan_primitive(document, primitive, number, report);
    if (!plan)
      result = plan.error();
    else if (*plan)
      plans.push_back(**std::move(plan));
  });
  if (!result) return result.error();
  report.converted = plans.size();
  return plans;
}

Result<SourceMesh> build_mesh(const Document& document, const StreamSource& source, bool keep_all,
                              std::size_t number) {
  constexpr std::size_t kMaxNameBytes = 255;
  SourceMesh result;
  DELTAMESH_TRY(const auto positions, required_rows(document, source.position));
  const std::uint64_t vertices = positions.shape().count;
  if (vertices > ~std::uint32_t{0})
    return Error{.code = ErrorCode::kLimitExceeded,
                 .message = "a primitive with more vertices than an index can number",
                 .where_kind = WhereKind::kElement,
                 .where = number};
  DELTAMESH_TRY(result.mesh.triangles, read_corners(document, source, vertices, number));
  const auto selected = select_vertices(result.mesh.triangles, vertices, keep_all);
  result.unreferenced_vertices = vertices - selected.size();

  const auto bytes = gather(positions, selected);
  result.mesh.positions.resize(selected.size() * 3);
  std::copy(bytes.begin(), bytes.end(), std::as_writable_bytes(std::span(result.mesh.positions)).begin());
  for (const CodedAttribute& coded : source.attributes) {
    DELTAMESH_TRY(const auto rows, required_rows(document, coded.accessor));
    Attribute& attribute = result.mesh.attributes.emplace_back();
    attribute.kind = kind_of(coded.semantic, rows.shape());
    attribute.type = rows.shape().type;
    attribute.components = rows.shape().components;
    attribute.normalized = rows.shape().normalized;
    if (coded.semantic.size() <= kMaxNameBytes) attribute.name = coded.semantic;
    attribute.values = gather(rows, selected);
  }
  return result;
}

}  // namespace deltamesh::gltf
