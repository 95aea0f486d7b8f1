// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "attributes/tangents/rule.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace deltamesh {
namespace {

constexpr float kLeastSquare = 1e-36F;  ///< of vectors that have a direction

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

  /// The way of a face at a corner by its angle, and the angle.
  FourFloats direction(std::size_t face, std::size_t corner) const noexcept {
    const float angle = angles_[corner][face];
    const float weight = angle * inverse_[face];
    return FourFloats{way_[0][face] * weight, way_[1][face] * weight, way_[2][face] * weight, angle};
  }
  float area(std::size_t face) const noexcept { return area_[face]; }

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
  if (normals.empty())
    own_normals_ = sum_by_rule(NormalRule::kArea, surface.triangles(), surface.positions());
  if (uvs.empty()) return;
  sums_ = LargeVector<Sum>(surface.vertex_count(), Sum{});
  const float scale = position_scale(surface.positions());
  const float uv_scale = position_scale(uvs);
  const auto triangles = surface.triangles();
  for (std::size_t c = 0; c < triangles.size(); c += 12) {
    // A place beyond the last takes the last face, and adds nothing.
    const std::size_t count = std::min<std::size_t>((triangles.size() - c) / 3, 4);
    std::array<const std::uint32_t*, 4> faces{};
    for (std::size_t i = 0; i < 4; ++i) faces[i] = triangles.data() + c + 3 * std::min(i, count - 1);
    const FourTextured four(faces, surface.positions().data(), scale, uvs.data(), uv_scale);
    for (std::size_t i = 0; i < count; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        Sum& sum = sums_[faces[i][k]];
        sum.direction += four.direction(i, k);
        sum.area += four.area(i);
      }
    }
  }
}

RuledTangent TangentRule::at(std::uint32_t vertex) const noexcept {
  RuledTangent result;
  if (!normals_.empty()) {
    const float* const n = normals_.data() + std::size_t{3} * vertex;
    result.normal = FourFloats{n[0], n[1], n[2], 0};
  } else if (!own_normals_.empty()) {
    result.normal = own_normals_[vertex];
    const float square = dot3(result.normal, result.normal);
    result.normal = square > 1e-36F ? result.normal * (1 / std::sqrt(square)) : FourFloats{};
  }
  if (sums_.empty()) return result;
  const FourFloats sum = sums_[vertex].direction;
  const float angles = sum[3];
  const float spread = angles > 0 ? 1 - dot3(sum, sum) / (angles * angles) : 0;
  result.dispersion = std::sqrt(spread > 0 ? spread : 0);
  result.direction = sum - dot3(result.normal, sum) * result.normal;
  result.area = sums_[vertex].area;
  return result;
}

}  // namespace deltamesh
