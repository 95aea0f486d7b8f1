// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Rooms whose colours are labels: each vertex has that of the nearest of some seeds.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "base/numbers/vec3.h"
#include "deltamesh/mesh.h"
#include "scenes.h"
#include "support/random.h"
#include "topology/adjacency.h"

namespace deltamesh::test {

struct LabelMap {
  std::string name;
  Mesh mesh;
};

namespace labels {

using Levels = std::vector<std::uint8_t>;  ///< n x 3

inline std::vector<std::uint32_t> nearest_seeds(const Mesh& mesh, std::uint32_t seed, std::uint32_t count) {
  RandomBits random(seed);
  const auto place = [&](std::size_t v) { return widen(mesh.positions.data() + 3 * v); };
  std::vector<Vec3> seeds(count);
  for (Vec3& s : seeds) s = place(random() % mesh.vertex_count());
  std::vector<std::uint32_t> nearest(mesh.vertex_count());
  for (std::size_t v = 0; v < nearest.size(); ++v)
    for (std::uint32_t k = 1; k < count; ++k)
      if (length(seeds[k] - place(v)) < length(seeds[nearest[v]] - place(v))) nearest[v] = k;
  return nearest;
}

inline Levels painted(const std::vector<std::uint32_t>& labels, const Levels& palette) {
  Levels colors;
  for (const std::uint32_t k : labels)
    for (std::size_t c = 0; c < 3; ++c) colors.push_back(palette[3 * k + c]);
  return colors;
}

/// Each colour is the mean of those around and itself.
inline Levels blended(const Levels& colors, const Adjacency& graph) {
  Levels result;
  for (std::uint32_t v = 0; v < graph.vertex_count(); ++v) {
    for (std::size_t c = 0; c < 3; ++c) {
      std::uint32_t sum = colors[3 * v + c];
      for (const std::uint32_t u : graph.of(v)) sum += colors[3 * u + c];
      result.push_back(static_cast<std::uint8_t>(sum / (1 + graph.degree(v))));
    }
  }
  return result;
}

/// One of a hundred has another colour.
inline Levels noisy(Levels colors, std::uint32_t seed) {
  RandomBits random(seed);
  for (std::size_t v = 0; 3 * v < colors.size(); v += 1 + random() % 199) colors[3 * v] ^= 0x55U;
  return colors;
}

}  // namespace labels

/// Five maps with `count` labels: of random colours, of numbers as colours, blended at
/// borders, blended twice, noisy.
inline std::vector<LabelMap> label_maps(std::uint32_t seed, std::uint32_t count,
                                        std::uint64_t vertices = 6000) {
  Mesh mesh = *generate_scene(Scene::kRooms, vertices, seed);
  const Adjacency graph = build_adjacency(mesh.triangles, static_cast<std::uint32_t>(mesh.vertex_count()));
  const auto nearest = labels::nearest_seeds(mesh, seed, count);
  RandomBits random(seed + count);
  labels::Levels palette(std::size_t{3} * count);
  for (std::uint8_t& x : palette) x = static_cast<std::uint8_t>(random());
  labels::Levels numbers(palette.size());
  for (std::uint32_t k = 0; k < count; ++k) {
    numbers[3 * k] = static_cast<std::uint8_t>(k);
    numbers[3 * k + 1] = static_cast<std::uint8_t>(k >> 8U);
  }
  const labels::Levels plain = labels::painted(nearest, palette);
  const labels::Levels once = labels::blended(plain, graph);
  const std::vector<std::pair<std::string, labels::Levels>> all = {
      {"plain", plain},
      {"numbers", labels::painted(nearest, numbers)},
      {"blended", once},
      {"blended twice", labels::blended(once, graph)},
      {"noisy", labels::noisy(plain, seed)}};
  std::vector<LabelMap> maps;
  for (const auto& [name, levels] : all) {
    Attribute colors{.kind = AttributeKind::kColor,
                     .type = ComponentType::kU8,
                     .components = 3,
                     .normalized = true,
                     .name = "red"};
    for (const std::uint8_t x : levels) colors.values.push_back(std::byte{x});
    mesh.attributes = {std::move(colors)};
    maps.push_back({name + ' ' + std::to_string(seed) + ' ' + std::to_string(count), mesh});
  }
  return maps;
}

}  // namespace deltamesh::test
