// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Meshes made up from a name, a size and a seed, for demonstrations, tests and benchmarks.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "deltamesh/mesh.h"
#include "deltamesh/result.h"

namespace deltamesh {

enum class Scene : std::uint8_t {
  kRooms,      ///< a robot's map of some rooms: TSDF, marching cubes, holes, fragments; colours; metres
  kTerrain,    ///< regular height field with a georeferenced origin; metres
  kSphere,     ///< lumpy sphere of irregular connectivity, closed
  kTorus,      ///< lumpy torus, closed, one handle
  kCad,        ///< drilled blocks and cylinders with sharp edges, normals and UV seams; millimetres
  kFragments,  ///< thousands of components of 1 to 50 vertices, some non-manifold, some faces twice
};

struct SceneName {
  Scene scene;
  std::string_view name;         ///< as on the command line
  std::string_view description;  ///< one line for help texts
};

/// All scenes, in the order of the enumeration.
std::span<const SceneName> scene_names() noexcept;

std::optional<Scene> scene_of_name(std::string_view name) noexcept;

inline constexpr std::uint64_t kMinSceneVertices = 12;
inline constexpr std::uint64_t kMaxSceneVertices = 20'000'000;

/// Makes the scene with about `vertices` vertices: within 10 % from 1000 on, the nearest that the scene can
/// be made of below. The same arguments give the same mesh with every compiler: only IEEE operations that are
/// correctly rounded are used. Cost: linear in `vertices`; rooms take a few seconds per million.
/// Errors: kInvalidArgument (`vertices` out of range). Throws std::bad_alloc only.
Result<Mesh> generate_scene(Scene scene, std::uint64_t vertices, std::uint64_t seed);

}  // namespace deltamesh
