// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Assets that more than one test program makes.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "support/gltf_asset.h"

namespace deltamesh::test {

/// A unit cube: six faces of four vertices, with normals and texture coordinates, and a material.
inline GltfBuilder cube_asset() {
  Sheet cube;
  for (std::uint32_t face = 0; face < 6; ++face) {
    const std::size_t axis = face / 2;
    const float side = face % 2 == 0 ? -1.0F : 1.0F;
    for (std::uint32_t corner = 0; corner < 4; ++corner) {
      const float u = corner % 2 == 0 ? -1.0F : 1.0F;
      const float v = corner / 2 == 0 ? -1.0F : 1.0F;
      std::array<float, 3> position{};
      position[axis] = side / 2;
      position[(axis + 1) % 3] = u / 2 * side;  // the side mirrors, so that every face looks outwards
      position[(axis + 2) % 3] = v / 2;
      std::array<float, 3> normal{};
      normal[axis] = side;
      cube.positions.insert(cube.positions.end(), position.begin(), position.end());
      cube.normals.insert(cube.normals.end(), normal.begin(), normal.end());
      cube.uvs.insert(cube.uvs.end(), {(u + 1) / 2, (1 - v) / 2});
    }
    const std::uint32_t a = face * 4;
    cube.triangles.insert(cube.triangles.end(), {a, a + 1, a + 2, a + 1, a + 3, a + 2});
  }
  GltfBuilder builder;
  builder.json["asset"]["generator"] = "deltamesh";
  builder.sheet_mesh(cube);
  builder.push("materials",
               {{"name", "grey"}, {"pbrMetallicRoughness", {{"baseColorFactor", {0.5, 0.5, 0.5, 1}}}}});
  builder.json["meshes"][0]["name"] = "cube";
  builder.json["meshes"][0]["primitives"][0]["material"] = 0;
  return builder;
}

/// The cube with its last face in a primitive and a material of its own, and a morph target that lifts it.
inline GltfBuilder two_material_cube_asset() {
  GltfBuilder builder = cube_asset();
  Json& primitives = builder.json["meshes"][0]["primitives"];
  std::vector<float> moves(72);
  for (std::size_t i = 0; i < 24; ++i) moves[3 * i + 1] = 0.25F;
  primitives[0]["targets"] = Json::array({Json{{"POSITION", builder.floats(moves, 3, true)}}});
  Json last = primitives[0];
  builder.json["accessors"][primitives[0]["indices"].get<std::size_t>()]["count"] = 30;
  last["indices"] = builder.indices({20, 21, 22, 21, 23, 22});
  last["material"] = builder.push("materials", {{"name", "white"}});
  primitives.push_back(last);
  return builder;
}

}  // namespace deltamesh::test
