// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The map whose parts are fuzzed: coloured waves, with a primer.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "deltamesh/map/map_codec.h"
#include "deltamesh/map/split.h"
#include "support/grid_triangles.h"

namespace deltamesh::fuzz {

inline Mesh waves(std::uint32_t side) {
  Mesh mesh;
  Attribute color{AttributeKind::kColor, ComponentType::kU8, 3, true, "red", {}};
  for (std::uint32_t y = 0; y <= side; ++y)
    for (std::uint32_t x = 0; x <= side; ++x) {
      for (const float coordinate : {0.02F * static_cast<float>(x), 0.02F * static_cast<float>(y),
                                     0.001F * static_cast<float>(x * y % 7)})
        mesh.positions.push_back(coordinate);
      for (std::uint32_t k = 1; k < 4; ++k) color.values.push_back(static_cast<std::byte>(k * x + y));
    }
  mesh.triangles = test::grid_triangles(side + 1, side + 1);
  mesh.attributes.push_back(color);
  return mesh;
}

/// Its parts, without primers.
inline std::vector<MapPart> make_parts(const MapDescription& description) {
  const auto parts = split(waves(24), description, {.most_triangles = 300, .most_level = 2});
  if (!parts) std::abort();
  return *parts;
}

inline MapCodec make_codec() {
  MapDescription description{.id = 1, .cell_steps = 150};
  description.attributes = {{AttributeKind::kColor, ComponentType::kU8, 3, true, "red"}};
  const auto with = with_primers(description, make_parts(description),
                                 {.bounds = {.max_error = QualityBound{0.002}}, .effort = 0});
  if (!with) std::abort();
  auto codec = MapCodec::open(*with);
  if (!codec) std::abort();
  return *std::move(codec);
}

}  // namespace deltamesh::fuzz
