// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "stream/borders.h"

#include <array>
#include <bit>
#include <cstdint>
#include <map>
#include <set>

#include "base/try.h"
#include "stream/corners.h"

namespace deltamesh::gltf {

Result<void> mark_borders(const AccessorStore& store, const std::vector<PrimitiveSource>& sources,
                          std::vector<StreamPlan>& plans) {
  std::map<std::size_t, std::set<std::size_t>> plans_of_mesh;
  for (std::size_t i = 0; i < plans.size(); ++i)
    for (const std::size_t primitive : plans[i].primitives) plans_of_mesh[sources[primitive].mesh].insert(i);
  for (const auto& [mesh, numbers] : plans_of_mesh) {
    if (numbers.size() < 2) continue;
    std::map<std::array<std::uint32_t, 3>, std::size_t> owners;  // by the bits of a position
    for (const std::size_t number : numbers) {
      for (const std::size_t primitive : plans[number].primitives) {
        const PrimitiveSource& source = sources[primitive];
        if (source.mesh != mesh) continue;
        DELTAMESH_TRY(const auto corners, read_corners(store, source));
        for (const std::uint32_t corner : corners) {
          const Vec3 position = vector_at(store.rows(source.position), corner);
          std::array<std::uint32_t, 3> bits{};
          for (std::size_t k = 0; k < 3; ++k)
            bits[k] = std::bit_cast<std::uint32_t>(static_cast<float>(position[k]) + 0.0F);  // one zero
          const std::size_t owner = owners.try_emplace(bits, number).first->second;
          if (owner != number) plans[owner].exact_positions = plans[number].exact_positions = true;
        }
      }
    }
  }
  return {};
}

}  // namespace deltamesh::gltf
