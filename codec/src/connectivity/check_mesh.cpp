// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "connectivity/check_mesh.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <span>

#include "base/try.h"
#include "format/chunk/attribute_descriptor.h"
#include "format/header.h"

namespace deltamesh {
namespace {

constexpr std::size_t kMaxAttributes = 1024;

Error invalid_mesh(const char* message, WhereKind kind = WhereKind::kNone, std::size_t where = 0) noexcept {
  return {.code = ErrorCode::kInvalidMesh, .message = message, .where_kind = kind, .where = where};
}

// Blocks without branches; where one has a fault, it is looked for.
constexpr std::size_t kBlock = 1024;

std::size_t first_not_finite(std::span<const float> values) noexcept {
  constexpr std::uint32_t kExponent = 0x7f800000;
  for (std::size_t begin = 0; begin < values.size(); begin += kBlock) {
    const std::size_t end = std::min(begin + kBlock, values.size());
    bool all = true;
    for (std::size_t i = begin; i < end; ++i)
      all &= (std::bit_cast<std::uint32_t>(values[i]) & kExponent) != kExponent;
    if (all) continue;
    while (std::isfinite(values[begin])) ++begin;
    return begin;
  }
  return values.size();
}

std::size_t first_not_below(std::span<const std::uint32_t> indices, std::size_t limit) noexcept {
  for (std::size_t begin = 0; begin < indices.size(); begin += kBlock) {
    const std::size_t end = std::min(begin + kBlock, indices.size());
    std::uint32_t most = 0;
    for (std::size_t i = begin; i < end; ++i) most = std::max(most, indices[i]);
    if (most < limit) continue;
    while (indices[begin] < limit) ++begin;
    return begin;
  }
  return indices.size();
}

Result<void> check_finite(const MeshView& mesh) noexcept {
  for (const double x : mesh.origin)
    if (!std::isfinite(x)) return invalid_mesh("the origin is not finite");
  if (const auto i = first_not_finite(mesh.positions); i < mesh.positions.size())
    return Error{.code = ErrorCode::kNotFinite,
                 .message = "a coordinate is NaN or infinite",
                 .where_kind = WhereKind::kVertex,
                 .where = i / 3};
  return {};
}

Result<void> check_attribute(const AttributeView& a, std::size_t vertices, std::size_t index) noexcept {
  if (a.components < 1 || a.components > kMaxComponents)
    return invalid_mesh("an attribute has 1 to 16 components", WhereKind::kAttribute, index);
  if (a.name.size() > kMaxAttributeName)
    return invalid_mesh("the attribute's name is longer than 255 bytes", WhereKind::kAttribute, index);
  if (a.values.size() != std::uint64_t{vertices} * a.components * component_size(a.type))
    return invalid_mesh("the attribute does not have one value per vertex", WhereKind::kAttribute, index);
  return {};
}

}  // namespace

Result<void> check_mesh(const MeshView& mesh, bool finite) noexcept {
  if (mesh.positions.size() % 3 != 0) return invalid_mesh("positions are not three numbers per vertex");
  if (mesh.triangles.size() % 3 != 0) return invalid_mesh("triangles are not three indices each");
  const std::size_t vertices = mesh.vertex_count();
  if (vertices > kMaxVertices || mesh.triangle_count() > kMaxTriangles)
    return Error{.code = ErrorCode::kLimitExceeded,
                 .message = "more than 2^31 - 1 vertices or 2^29 triangles",
                 .rule = "HDR-6"};
  if (finite) DELTAMESH_CHECK(check_finite(mesh));
  if (const auto i = first_not_below(mesh.triangles, vertices); i < mesh.triangles.size())
    return invalid_mesh("an index is not below the number of vertices", WhereKind::kTriangle, i / 3);
  if (!mesh.face_groups.empty() && mesh.face_groups.size() != mesh.triangle_count())
    return invalid_mesh("there is not one group for every triangle");
  if (const auto i = first_not_below(mesh.face_groups, kMostGroups); i < mesh.face_groups.size())
    return invalid_mesh("the number of a group is not below 2^16", WhereKind::kTriangle, i);
  if (mesh.attributes.size() > kMaxAttributes)
    return Error{.code = ErrorCode::kLimitExceeded, .message = "more than 1024 attributes"};
  for (std::size_t i = 0; i < mesh.attributes.size(); ++i)
    DELTAMESH_CHECK(check_attribute(mesh.attributes[i], vertices, i));
  return {};
}

}  // namespace deltamesh
