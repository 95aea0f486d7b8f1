// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "scenes.h"

#include <algorithm>

#include "generators.h"

namespace deltamesh {
namespace {

constexpr SceneName kScenes[] = {
    {Scene::kRooms, "rooms", "a robot's map of furnished rooms: marching cubes, holes, fragments, colours"},
    {Scene::kTerrain, "terrain", "height field far from the origin, on a regular grid"},
    {Scene::kSphere, "sphere", "lumpy sphere of irregular triangles"},
    {Scene::kTorus, "torus", "lumpy torus"},
    {Scene::kCad, "cad", "drilled blocks and cylinders: sharp edges, long triangles, normals, UV seams"},
    {Scene::kFragments, "fragments", "thousands of tiny components, some non-manifold"},
};

Mesh make(Scene scene, std::uint64_t vertices, std::uint64_t seed) {
  switch (scene) {
    case Scene::kRooms:
      return scenes::make_rooms(vertices, seed);
    case Scene::kTerrain:
      return scenes::make_terrain(vertices, seed);
    case Scene::kSphere:
      return scenes::make_sphere(vertices, seed);
    case Scene::kTorus:
      return scenes::make_torus(vertices, seed);
    case Scene::kCad:
      return scenes::make_cad(vertices, seed);
    case Scene::kFragments:
      break;
  }
  return scenes::make_fragments(vertices, seed);
}

}  // namespace

std::span<const SceneName> scene_names() noexcept { return kScenes; }

std::optional<Scene> scene_of_name(std::string_view name) noexcept {
  const auto* found = std::find_if(std::begin(kScenes), std::end(kScenes),
                                   [name](const SceneName& s) { return s.name == name; });
  if (found == std::end(kScenes)) return std::nullopt;
  return found->scene;
}

Result<Mesh> generate_scene(Scene scene, std::uint64_t vertices, std::uint64_t seed) {
  if (vertices < kMinSceneVertices || vertices > kMaxSceneVertices)
    return Error{.code = ErrorCode::kInvalidArgument,
                 .message = "a scene has between 12 and 20000000 vertices"};
  return make(scene, vertices, seed);
}

}  // namespace deltamesh
