// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "asset/source.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <utility>

#include "asset/gltf_meshes.h"
#include "base/try.h"
#include "deltamesh/gltf.h"
#include "deltamesh/io.h"
#include "scenes.h"

namespace deltamesh::bench {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 3> kQuickNames = {"Duck", "Lantern", "cakeBirthday"};

Result<Asset> load_file(const std::string& path) {
  DELTAMESH_TRY(const auto bytes, read_file(path));
  GltfIo io;
  io.resolve = [folder = fs::path(path).parent_path()](std::string_view uri) {
    return read_file((folder / uri).string());
  };
  DELTAMESH_TRY(Asset asset, meshes_of_asset(bytes, io));
  asset.name = fs::path(path).stem().string();
  return asset;
}

Result<Asset> generate(const std::string& name, std::uint64_t vertices) {
  constexpr std::uint64_t kSeed = 1;
  DELTAMESH_TRY(const Mesh mesh, generate_scene(Scene::kCad, vertices, kSeed));
  DELTAMESH_TRY(const auto bytes, write_mesh(mesh, FileFormat::kGlb));
  DELTAMESH_TRY(Asset asset, meshes_of_asset(bytes, {}));
  asset.name = name;
  return asset;
}

}  // namespace

std::vector<AssetSource> corpus_assets(const std::string& folder) {
  std::vector<AssetSource> sources;
  for (const fs::path& path : corpus_files(folder, {"gltf", "formats"}, {".glb", ".gltf"}))
    sources.push_back(asset_file(path.string()));
  std::ranges::sort(sources, {}, &AssetSource::name);
  return sources;
}

AssetSource asset_file(const std::string& path) {
  return {.name = fs::path(path).stem().string(), .load = [path] { return load_file(path); }};
}

AssetSource generated_asset(std::uint64_t vertices) {
  const std::string name = "generated cad";
  return {.name = name, .load = [name, vertices] { return generate(name, vertices); }};
}

bool is_quick_asset(const std::string& name) { return std::ranges::count(kQuickNames, name) != 0; }

}  // namespace deltamesh::bench
