// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "stream/borders.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <map>
#include <tuple>

#include "base/try.h"
#include "base/union_find.h"
#include "io/gltf/scene.h"
#include "stream/corners.h"

namespace deltamesh::gltf {
namespace {

/// A place in the asset: meshes of one `space` have nodes with the same transform.
struct Place {
  std::size_t space = 0;
  std::array<std::uint32_t, 3> bits{};
  std::size_t plan = 0;
  bool operator==(const Place&) const = default;
  bool operator<(const Place& other) const noexcept {
    return std::tie(space, bits, plan) < std::tie(other.space, other.bits, other.plan);
  }
};

/// The space of every mesh, a number below `meshes`.
Result<std::vector<std::size_t>> find_spaces(const Document& document) {
  const std::size_t meshes = array_size(document.json, "meshes");
  DELTAMESH_TRY(const auto placements, place_meshes(document));
  UnionFind spaces(meshes);
  std::map<std::array<double, 16>, std::size_t> first_at;
  for (const Placement& placement : placements)
    spaces.unite(placement.mesh, first_at.try_emplace(placement.transform.m, placement.mesh).first->second);
  std::vector<std::size_t> space_of(meshes);
  for (std::size_t mesh = 0; mesh < meshes; ++mesh) space_of[mesh] = spaces.find(mesh);
  return space_of;
}

void sort_unique(std::vector<Place>& places) {
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
}

}  // namespace

Result<void> mark_borders(const AccessorStore& store, const std::vector<PrimitiveSource>& sources,
                          std::vector<StreamPlan>& plans) {
  if (plans.size() < 2) return {};
  DELTAMESH_TRY(const auto space_of, find_spaces(store.document()));
  std::vector<Place> places;
  for (std::size_t plan = 0; plan < plans.size(); ++plan) {
    std::vector<Place> own;
    for (const std::size_t primitive : plans[plan].primitives) {
      const PrimitiveSource& source = sources[primitive];
      DELTAMESH_TRY(const auto corners, read_corners(store, source));
      for (const std::uint32_t corner : corners) {
        const Vec3 position = vector_at(store.rows(source.position), corner);
        Place& place = own.emplace_back(Place{.space = space_of[source.number.mesh], .plan = plan});
        for (std::size_t k = 0; k < 3; ++k)
          place.bits[k] = std::bit_cast<std::uint32_t>(static_cast<float>(position[k]) + 0.0F);  // one zero
      }
      sort_unique(own);
    }
    places.insert(places.end(), own.begin(), own.end());
  }
  std::sort(places.begin(), places.end());
  UnionFind lattices(plans.size());
  std::vector<bool> borders(plans.size());
  for (std::size_t i = 1; i < places.size(); ++i) {
    const Place& a = places[i - 1];
    const Place& b = places[i];
    if (a.space != b.space || a.bits != b.bits) continue;
    lattices.unite(a.plan, b.plan);
    borders[a.plan] = borders[b.plan] = true;
  }
  for (std::size_t plan = 0; plan < plans.size(); ++plan)
    if (borders[plan]) plans[plan].lattice = lattices.find(plan);
  return {};
}

}  // namespace deltamesh::gltf
