// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "run/bench_mesh.h"

#include <algorithm>
#include <array>
#include <bit>
#include <filesystem>
#include <limits>
#include <map>
#include <string_view>

#include "deltamesh/io.h"
#include "scenes.h"

namespace deltamesh::bench {
namespace {

constexpr std::array<std::string_view, 6> kQuickNames = {"paper/bunny_34834",       "paper/horse_4243",
                                                         "models/nefertiti_50k",    "models/fandisk",
                                                         "robot/kitchen_tsdf_20mm", "robot/building_sim_50k"};

Result<Mesh> load_file(const std::string& path) {
  auto imported = read_mesh_file(path);
  if (!imported) return imported.error();
  return std::move(imported->mesh);
}

}  // namespace

std::vector<MeshSource> corpus_meshes(const std::string& folder) {
  namespace fs = std::filesystem;
  std::vector<MeshSource> sources;
  for (const char* group : {"paper", "models", "robot"}) {
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(fs::path(folder) / group, error)) {
      if (entry.path().extension() != ".ply") continue;
      sources.push_back({.name = std::string(group) + "/" + entry.path().stem().string(),
                         .load = [path = entry.path().string()] { return load_file(path); }});
    }
  }
  std::sort(sources.begin(), sources.end(),
            [](const MeshSource& a, const MeshSource& b) { return a.name < b.name; });
  return sources;
}

std::vector<MeshSource> generated_meshes(std::uint64_t vertices) {
  constexpr std::uint64_t kSeed = 1;
  std::vector<MeshSource> sources;
  for (const SceneName& entry : scene_names()) {
    sources.push_back(
        {.name = "generated/" + std::string(entry.name),
         .load = [scene = entry.scene, vertices] { return generate_scene(scene, vertices, kSeed); }});
  }
  return sources;
}

bool is_quick_mesh(const MeshSource& source) {
  return std::find(kQuickNames.begin(), kQuickNames.end(), source.name) != kQuickNames.end();
}

Mesh welded_geometry(const Mesh& mesh) {
  constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  std::map<std::array<std::uint32_t, 3>, std::uint32_t> place;  // first vertex at each position
  std::vector<std::uint32_t> first(mesh.vertex_count());
  for (std::uint32_t v = 0; v < first.size(); ++v) {
    std::array<std::uint32_t, 3> bits{};
    for (std::size_t axis = 0; axis < 3; ++axis)
      bits[axis] = std::bit_cast<std::uint32_t>(mesh.positions[std::size_t{3} * v + axis]);
    first[v] = place.try_emplace(bits, v).first->second;
  }
  Mesh result;
  result.origin = mesh.origin;
  std::vector<std::uint32_t> number(first.size(), kNone);
  for (std::size_t f = 0; f < mesh.triangle_count(); ++f) {
    std::array<std::uint32_t, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k) corners[k] = first[mesh.triangles[3 * f + k]];
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) continue;
    for (const std::uint32_t v : corners) {
      if (number[v] == kNone) {
        number[v] = static_cast<std::uint32_t>(result.vertex_count());
        const auto* position = mesh.positions.data() + std::size_t{3} * v;
        result.positions.insert(result.positions.end(), position, position + 3);
      }
      result.triangles.push_back(number[v]);
    }
  }
  return result;
}

}  // namespace deltamesh::bench
