// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "io/gltf/triangles.h"

#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <numeric>

#include "base/numbers/vec3.h"
#include "base/try.h"

namespace deltamesh::gltf {
namespace {

/// A strip or a fan as a list, each triangle turned as glTF says (2.0, 3.7.2.1).
std::vector<std::uint32_t> as_list(const std::vector<std::uint32_t>& path, TriangleMode mode) {
  std::vector<std::uint32_t> corners;
  for (std::size_t i = 0; i + 2 < path.size(); ++i) {
    if (mode == TriangleMode::kFan)
      corners.insert(corners.end(), {path[i + 1], path[i + 2], path[0]});
    else
      corners.insert(corners.end(), {path[i], path[i + 1 + i % 2], path[i + 2 - i % 2]});
  }
  return corners;
}

}  // namespace

Result<std::optional<TrianglePrimitive>> triangle_primitive(const Json& primitive,
                                                            const PrimitiveNumber& number) {
  constexpr auto kList = static_cast<std::uint64_t>(TriangleMode::kList);
  constexpr auto kFan = static_cast<std::uint64_t>(TriangleMode::kFan);
  const Error bad_mode = primitive_error("the primitive's mode is malformed", number);
  DELTAMESH_TRY(const auto mode, unsigned_member(primitive, "mode", kList, kFan, bad_mode));
  const Json* position = find(primitive["attributes"], "POSITION");
  if (mode < kList || !position) return std::optional<TrianglePrimitive>();
  TrianglePrimitive result{
      .number = number, .mode = static_cast<TriangleMode>(mode), .position = position->get<std::size_t>()};
  if (const Json* indices = find(primitive, "indices")) result.indices = indices->get<std::size_t>();
  return std::optional(result);
}

Result<std::vector<std::uint32_t>> triangle_corners(const TrianglePrimitive& primitive,
                                                    std::uint64_t vertices, const AccessorRows* indices) {
  if (vertices > ~std::uint32_t{0})
    return at_primitive({.code = ErrorCode::kLimitExceeded,
                         .message = "a primitive with more vertices than an index can number"},
                        primitive.number);
  if (indices && !is_index_shape(indices->shape()))
    return primitive_error("the primitive's indices are not unsigned integers", primitive.number);
  const bool is_list = primitive.mode == TriangleMode::kList;
  const std::uint64_t count = indices ? indices->shape().count : vertices;
  std::vector<std::uint32_t> corners(static_cast<std::size_t>(is_list ? count / 3 * 3 : count));
  if (!indices) std::iota(corners.begin(), corners.end(), 0U);
  for (std::size_t i = 0; indices && i < corners.size(); ++i) {
    corners[i] = read_index(indices->row(i));
    if (corners[i] >= vertices)
      return primitive_error("a vertex index beyond the primitive's vertices", primitive.number);
  }
  return is_list ? corners : as_list(corners, primitive.mode);
}

void write_face_normals(const Mesh& mesh, std::span<const std::uint32_t> corners,
                        std::span<std::byte> normals) {
  std::map<std::uint32_t, Vec3> sums;
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    const auto c = corners.subspan(i, 3);
    const auto at = [&](std::size_t k) { return widen(&mesh.positions[3 * std::size_t{c[k]}]); };
    const Vec3 normal = cross(at(1) - at(0), at(2) - at(0));
    for (const std::uint32_t corner : c) sums[corner] = sums[corner] + normal;
  }
  for (const auto& [vertex, sum] : sums) {
    const double size = length(sum);
    if (!(size > 0) || !std::isfinite(size)) continue;
    std::array<float, 3> unit{};
    for (std::size_t k = 0; k < 3; ++k) unit[k] = static_cast<float>(sum[k] / size);
    std::memcpy(normals.data() + vertex * sizeof unit, unit.data(), sizeof unit);
  }
}

}  // namespace deltamesh::gltf
