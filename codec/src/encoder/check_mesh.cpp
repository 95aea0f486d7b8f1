// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "encoder/check_mesh.h"

#include <cmath>

#include "base/try.h"
#include "format/header.h"

namespace deltamesh {
namespace {

constexpr std::size_t kMaxAttributes = 64;
constexpr std::size_t kMaxNameBytes = 255;
constexpr std::uint8_t kMaxComponents = 16;

Error invalid(const char* message, WhereKind kind = WhereKind::kNone, std::size_t where = 0) noexcept {
  return {.code = ErrorCode::kInvalidMesh, .message = message, .where_kind = kind, .where = where};
}

Result<void> check_attribute(const AttributeView& a, std::size_t vertices, std::size_t index) {
  if (a.components < 1 || a.components > kMaxComponents)
    return invalid("an attribute has 1 to 16 components", WhereKind::kAttribute, index);
  if (a.name.size() > kMaxNameBytes)
    return invalid("the attribute's name is longer than 255 bytes", WhereKind::kAttribute, index);
  if (a.values.size() != vertices * a.components * component_size(a.type))
    return invalid("the attribute does not have one value per vertex", WhereKind::kAttribute, index);
  return {};
}

}  // namespace

Result<void> check_mesh(const MeshView& mesh) {
  if (mesh.positions.size() % 3 != 0) return invalid("positions are not three numbers per vertex");
  if (mesh.triangles.size() % 3 != 0) return invalid("triangles are not three indices each");
  const std::size_t vertices = mesh.vertex_count();
  if (vertices > kMaxVertices || mesh.triangle_count() > kMaxTriangles)
    return Error{.code = ErrorCode::kLimitExceeded,
                 .message = "more than 2^31 - 1 vertices or 2^29 triangles",
                 .rule = "HDR-6"};
  for (const double x : mesh.origin) {
    if (!std::isfinite(x)) return invalid("the origin is not finite");
  }
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    if (!std::isfinite(mesh.positions[i]))
      return invalid("a coordinate is NaN or infinite", WhereKind::kVertex, i / 3);
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (mesh.triangles[i] >= vertices)
      return invalid("an index is not below the number of vertices", WhereKind::kTriangle, i / 3);
  }
  if (mesh.attributes.size() > kMaxAttributes)
    return Error{.code = ErrorCode::kLimitExceeded, .message = "more than 64 attributes"};
  for (std::size_t i = 0; i < mesh.attributes.size(); ++i)
    DELTAMESH_CHECK(check_attribute(mesh.attributes[i], vertices, i));
  return {};
}

}  // namespace deltamesh
