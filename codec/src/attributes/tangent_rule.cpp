// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "attributes/tangent_rule.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace deltamesh {
namespace {

constexpr float kLeastSquare = 1e-36F;  ///< of vectors that have a direction

Vec3 triple(std::span<const float> values, std::uint32_t vertex) noexcept {
  const float* const v = values.data() + std::size_t{3} * vertex;
  return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
}

/// `x` less what of it is along the unit vector `normal`.
Vec3 across(const Vec3& x, const Vec3& normal) noexcept { return x - dot(normal, x) * normal; }

/// Unit, of n x 3: the sums of the faces' areas, 0 where there is no direction.
std::vector<float> area_normals(const AttributeSurface& surface) {
  std::vector<Vec3> sums(surface.vertex_count());
  const auto triangles = surface.triangles();
  for (std::size_t c = 0; c < triangles.size(); c += 3) {
    const Vec3 origin = triple(surface.positions(), triangles[c]);
    const Vec3 area = cross(triple(surface.positions(), triangles[c + 1]) - origin,
                            triple(surface.positions(), triangles[c + 2]) - origin);
    for (std::size_t k = 0; k < 3; ++k) sums[triangles[c + k]] = sums[triangles[c + k]] + area;
  }
  std::vector<float> normals;
  normals.reserve(3 * sums.size());
  for (Vec3& sum : sums) {
    if (normalize(sum) == 0) sum = {};
    for (const double x : sum) normals.push_back(static_cast<float>(x));
  }
  return normals;
}

/// Four faces at once, and what they add at their corners.
class FourTextured {
 public:
  FourTextured(const std::array<const std::uint32_t*, 4>& faces, const float* positions, float scale,
               const float* uvs, float uv_scale) noexcept {
    const auto gather = [&](std::size_t k, const float* values, std::size_t width, std::size_t c) {
      const auto at = [&](std::size_t face) { return values[width * faces[face][k] + c]; };
      return FourFloats{at(0), at(1), at(2), at(3)};
    };
    const auto place = [&](std::size_t k) {
      return FourVectors{gather(k, positions, 3, 0) * scale, gather(k, positions, 3, 1) * scale,
                         gather(k, positions, 3, 2) * scale};
    };
    const auto uv = [&](std::size_t k, std::size_t c) { return gather(k, uvs, 2, c) * uv_scale; };
    const FourVectors origin = place(0);
    const FourVectors a = place(1) - origin;
    const FourVectors b = place(2) - origin;
    const FourVectors n = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    const FourFloats v1 = uv(1, 1) - uv(0, 1);
    const FourFloats v2 = uv(2, 1) - uv(0, 1);
    const FourFloats area = (uv(1, 0) - uv(0, 0)) * v2 - (uv(2, 0) - uv(0, 0)) * v1;
    FourVectors way = {v2 * a[0] - v1 * b[0], v2 * a[1] - v1 * b[1], v2 * a[2] - v1 * b[2]};
    const FourFloats square = dot(way, way);
    const FourFloats normal_square = dot(n, n);
    const auto counts = (area != 0) & (square > kLeastSquare) & (normal_square > kLeastSquare);
    const FourFloats none{};
    area_ = counts ? area : none;
    for (FourFloats& x : way) x = counts ? (area < 0 ? -x : x) : none;
    way_ = way;
    inverse_ = 1 / square_roots(counts ? square : none + 1);
    const FourFloats size = square_roots(counts ? normal_square : none + 1);
    const FourFloats first = corner_angles(dot(a, b), size);
    const FourFloats second = corner_angles(none - dot(a, b - a), size);
    angles_ = {counts ? first : none, counts ? second : none, counts ? 3.14159265F - first - second : none};
  }

  void add_to(EightFloats& sum, std::size_t face, std::size_t corner) const noexcept {
    const float angle = angles_[corner][face];
    const float weight = angle * inverse_[face];
    const float x = way_[0][face];
    const float y = way_[1][face];
    const float z = way_[2][face];
    sum += EightFloats{x * weight, y * weight, z * weight, angle, x, y, z, area_[face]};
  }

 private:
  FourFloats area_;
  FourVectors way_;
  FourFloats inverse_;
  std::array<FourFloats, 3> angles_;
};

}  // namespace

TangentRule::TangentRule(const AttributeSurface& surface, std::span<const float> normals,
                         std::span<const float> uvs)
    : normals_(normals) {
  if (!surface.has_positions()) return;
  if (normals.empty()) {
    own_normals_ = area_normals(surface);
    normals_ = own_normals_;
  }
  if (uvs.empty()) return;
  sums_ = LargeVector<EightFloats>(surface.vertex_count(), EightFloats{});
  const float scale = position_scale(surface.positions());
  const float uv_scale = position_scale(uvs);
  const auto triangles = surface.triangles();
  for (std::size_t c = 0; c < triangles.size(); c += 12) {
    // A place beyond the last takes the last face, and adds nothing.
    const std::size_t count = std::min<std::size_t>((triangles.size() - c) / 3, 4);
    std::array<const std::uint32_t*, 4> faces{};
    for (std::size_t i = 0; i < 4; ++i) faces[i] = triangles.data() + c + 3 * std::min(i, count - 1);
    const FourTextured four(faces, surface.positions().data(), scale, uvs.data(), uv_scale);
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t k = 0; k < 3; ++k) four.add_to(sums_[faces[i][k]], i, k);
  }
}

RuledTangent TangentRule::at(std::uint32_t vertex) const noexcept {
  RuledTangent result;
  if (!normals_.empty()) result.normal = triple(normals_, vertex);
  if (normalize(result.normal) == 0) result.normal = {};
  if (sums_.empty()) return result;
  const EightFloats& sum = sums_[vertex];
  const auto vector_at = [&](std::size_t k) {
    return Vec3{static_cast<double>(sum[k]), static_cast<double>(sum[k + 1]),
                static_cast<double>(sum[k + 2])};
  };
  const auto angles = static_cast<double>(sum[3]);
  const Vec3 by_angle = vector_at(0);
  result.area = static_cast<double>(sum[7]);
  result.dispersion = angles > 0 ? std::sqrt(2 * std::fmax(0, 1 - length(by_angle) / angles)) : 0;
  result.direction = across(by_angle, result.normal);
  result.by_area = across(vector_at(4), result.normal);
  if (normalize(result.direction) == 0) result.direction = {};
  if (normalize(result.by_area) == 0) result.by_area = result.direction;
  return result;
}

}  // namespace deltamesh
