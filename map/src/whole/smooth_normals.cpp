// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "deltamesh/map/smooth_normals.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "base/guard.h"
#include "base/numbers/vec3.h"
#include "base/try.h"
#include "lattice/positions.h"
#include "support/errors.h"

namespace deltamesh {
namespace {

/// Twice its area long, of a face at a position.
using Share = std::pair<PositionBits, Vec3>;

Vec3 normal_of(const Mesh& mesh, const std::uint32_t* face) noexcept {
  const auto place = [&](std::size_t corner) {
    return widen(mesh.positions.data() + 3 * std::size_t{face[corner]});
  };
  return cross(place(1) - place(0), place(2) - place(0));
}

/// Those at positions that `takes` accepts.
template <class Takes>
Result<void> add_shares(const Mesh& mesh, Takes takes, std::vector<Share>& shares) {
  for (std::size_t f = 0; f < mesh.triangle_count(); ++f) {
    const std::uint32_t* face = &mesh.triangles[3 * f];
    for (std::size_t corner = 0; corner < 3; ++corner)
      if (face[corner] >= mesh.vertex_count()) return invalid_argument("a face beyond the vertices");
    for (std::size_t corner = 0; corner < 3; ++corner)
      if (const PositionBits position = bits_of(mesh, face[corner]); takes(face[corner], position))
        shares.emplace_back(position, normal_of(mesh, face));
  }
  return {};
}

/// Ascending: the sum is the same whichever part it is made for.
Vec3 sum_of(std::span<const Share> shares) noexcept {
  Vec3 sum{};
  for (const auto& [position, normal] : shares) sum = sum + normal;
  const double size = length(sum);
  if (!(size > 0)) return {0, 0, 1};
  for (double& x : sum) x /= size;
  return sum;
}

}  // namespace

Result<std::vector<float>> smooth_normals(const MapPart& part,
                                          std::span<const MapPart* const> others) noexcept {
  return guarded([&]() -> Result<std::vector<float>> {
    std::vector<PositionBits> border;
    for (const BorderVertex& vertex : part.border) {
      if (vertex.vertex >= part.mesh.vertex_count())
        return invalid_argument("a border vertex beyond the vertices");
      border.push_back(bits_of(part.mesh, vertex.vertex));
    }
    std::ranges::sort(border);
    std::vector<Share> shares;
    DELTAMESH_CHECK(add_shares(
        part.mesh, [](std::uint32_t, const PositionBits&) { return true; }, shares));
    for (const MapPart* other : others) {
      if (other == nullptr || other->key == part.key) continue;
      std::vector<bool> is_border(other->mesh.vertex_count());
      for (const BorderVertex& vertex : other->border)
        if (vertex.vertex < is_border.size()) is_border[vertex.vertex] = true;
      const auto is_common = [&](std::uint32_t vertex, const PositionBits& position) {
        return is_border[vertex] && std::ranges::binary_search(border, position);
      };
      DELTAMESH_CHECK(add_shares(other->mesh, is_common, shares));
    }
    std::ranges::sort(shares);
    std::vector<float> normals;
    normals.reserve(part.mesh.positions.size());
    for (std::size_t v = 0; v < part.mesh.vertex_count(); ++v) {
      const PositionBits position = bits_of(part.mesh, v);
      const auto begin = std::ranges::lower_bound(shares, position, {}, &Share::first);
      const auto end = std::ranges::upper_bound(shares, position, {}, &Share::first);
      for (const double x : sum_of({begin, end})) normals.push_back(static_cast<float>(x));
    }
    return normals;
  });
}

}  // namespace deltamesh
