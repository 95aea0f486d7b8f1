// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "support/corpus.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <set>
#include <span>
#include <utility>

#include "deltamesh/io.h"
#include "scenes.h"
#include "support/vertex_picker.h"

namespace deltamesh::bench {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 6> kQuickNames = {"paper/bunny_34834",       "paper/horse_4243",
                                                         "models/nefertiti_50k",    "models/fandisk",
                                                         "robot/kitchen_tsdf_20mm", "robot/building_sim_50k"};

}  // namespace

std::string default_corpus() {
  const char* folder = std::getenv("DELTAMESH_CORPUS");
  return folder != nullptr ? folder : "../shared/corpus";
}

std::vector<fs::path> corpus_files(const std::string& corpus, std::initializer_list<const char*> groups,
                                   std::initializer_list<std::string_view> suffixes) {
  std::vector<fs::path> paths;
  for (const char* group : groups) {
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(fs::path(corpus) / group, error))
      if (std::ranges::count(suffixes, entry.path().extension().string()) != 0) paths.push_back(entry.path());
  }
  std::ranges::sort(paths);
  return paths;
}

Result<Mesh> load_mesh(const std::string& path) {
  auto imported = read_mesh_file(path);
  if (!imported) return imported.error();
  return std::move(imported->mesh);
}

std::vector<MeshSource> corpus_meshes(const std::string& corpus) {
  std::vector<MeshSource> sources;
  for (const fs::path& path : corpus_files(corpus, {"models", "paper", "robot"}, {".ply"}))
    sources.push_back({.name = path.parent_path().filename().string() + "/" + path.stem().string(),
                       .load = [path] { return load_mesh(path.string()); }});
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

bool is_quick_mesh(const std::string& name) { return std::ranges::count(kQuickNames, name) != 0; }

Mesh welded_geometry(const Mesh& mesh) {
  const Mesh bare{.origin = mesh.origin,
                  .positions = mesh.positions,
                  .triangles = {},
                  .attributes = {},
                  .face_groups = {}};
  VertexPicker picker(bare, true);
  for (std::size_t f = 0; f < mesh.triangle_count(); ++f) {
    const std::span corners = std::span(mesh.triangles).subspan(3 * f, 3);
    std::set<std::string> places;
    for (const std::uint32_t v : corners) places.insert(position_bits(mesh, v));
    if (places.size() < 3) continue;
    for (const std::uint32_t v : corners) picker.add_corner(v);
  }
  return picker.take();
}

}  // namespace deltamesh::bench
