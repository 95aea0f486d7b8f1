// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// write_validator_assets FOLDER: packed assets with fallback, packed without, unpacked ones, and what the
// exporter of deltamesh::io writes, for validate.mjs. Fails where any of it cannot be made.
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "deltamesh/gltf.h"
#include "deltamesh/io.h"
#include "sample_assets.h"

namespace {

using namespace deltamesh;
using test::Bytes;
using test::bytes_of;
using test::GltfBuilder;
using test::Json;
using test::make_sheet;

std::filesystem::path folder;

template <class T>
T need(Result<T> result, const std::string& what) {
  if (!result) {
    std::fprintf(stderr, "%s: %s\n", what.c_str(), describe(result.error()).c_str());
    std::exit(1);
  }
  return *std::move(result);
}

void write(const std::string& name, const Bytes& bytes) {
  if (!write_file((folder / name).string(), bytes)) std::exit(1);
}

std::string path(const std::string& name) { return (folder / name).string(); }

/// All forms of the asset at `in`.
void write_forms(const std::string& in, const std::string& name) {
  GltfPackOptions options;
  need(pack_gltf_file(in, path(name + "_required.glb"), options), name);
  options.fallback = true;
  need(pack_gltf_file(in, path(name + "_fallback.glb"), options), name);
  need(pack_gltf_file(in, path(name + "_fallback.gltf"), options), name);
  need(unpack_gltf_file(path(name + "_required.glb"), path(name + "_unpacked.glb")), name);
  need(unpack_gltf_file(path(name + "_fallback.gltf"), path(name + "_unpacked.gltf")), name);
}

void write_forms(const GltfBuilder& builder, const std::string& name) {
  write(name + "_original.glb", builder.glb());
  write_forms(path(name + "_original.glb"), name);
}

GltfBuilder split_sheet() {
  GltfBuilder builder;
  const auto sheet = make_sheet(12);
  builder.sheet_mesh(sheet);
  Json& primitives = builder.json["meshes"][0]["primitives"];
  Json second = primitives[0];
  primitives[0]["indices"] = builder.indices({sheet.triangles.begin(), sheet.triangles.begin() + 300});
  second["indices"] = builder.indices({sheet.triangles.begin() + 300, sheet.triangles.end()});
  primitives.push_back(second);
  return builder;
}

/// Morph targets, colours of bytes, an application's attribute, an animation.
GltfBuilder morphing_sheet() {
  GltfBuilder builder;
  const auto sheet = make_sheet(9);
  builder.sheet_mesh(sheet);
  Json& primitive = builder.json["meshes"][0]["primitives"][0];
  primitive["targets"] = Json::array({Json{{"POSITION", builder.floats(sheet.normals, 3, true)}}});
  std::vector<std::uint8_t> colours(81 * 4);
  for (std::size_t i = 0; i < colours.size(); ++i) colours[i] = static_cast<std::uint8_t>(i % 4 == 3 ? 0 : i);
  const std::size_t view = builder.view(bytes_of(colours), 34962);
  builder.json["bufferViews"][view]["byteStride"] = 4;
  primitive["attributes"]["COLOR_0"] = builder.push(
      "accessors",
      {{"bufferView", view}, {"componentType", 5121}, {"normalized", true}, {"count", 81}, {"type", "VEC3"}});
  primitive["attributes"]["_HEAT"] = builder.floats(std::vector<float>(81, 3.5F), 1);
  builder.json["meshes"][0]["weights"] = {0.25};
  const std::size_t times = builder.floats({0, 1}, 1, true, 0);
  const std::size_t weights = builder.floats({0, 1}, 1, false, 0);
  builder.push(
      "animations",
      {{"samplers", Json::array({Json{{"input", times}, {"output", weights}}})},
       {"channels", Json::array({Json{{"sampler", 0}, {"target", {{"node", 0}, {"path", "weights"}}}}})}});
  return builder;
}

/// What the exporter makes of a mesh with every kind of attribute and an origin.
void write_exported() {
  const auto sheet = make_sheet(10);
  Mesh mesh;
  mesh.positions = sheet.positions;
  mesh.triangles = sheet.triangles;
  mesh.origin = {500000, 5100000, 1000};
  mesh.attributes.push_back(
      {AttributeKind::kNormal, ComponentType::kF32, 3, false, "NORMAL", bytes_of(sheet.normals)});
  mesh.attributes.push_back(
      {AttributeKind::kUv, ComponentType::kF32, 2, false, "TEXCOORD_0", bytes_of(sheet.uvs)});
  mesh.attributes.push_back(
      {AttributeKind::kColor, ComponentType::kU8, 3, true, "COLOR_0", Bytes(300, std::byte{99})});
  mesh.attributes.push_back({AttributeKind::kGeneric, ComponentType::kF32, 1, false, "confidence",
                             bytes_of(std::vector<float>(100, 0.5F))});
  write("exported.glb", need(write_mesh(mesh, FileFormat::kGlb), "exported.glb"));
  write("exported.gltf", need(write_mesh(mesh, FileFormat::kGltf), "exported.gltf"));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  folder = argv[1];
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  write_forms(test::cube_asset(), "cube");
  write_forms(split_sheet(), "split");
  write_forms(test::two_material_cube_asset(), "two_materials");
  write_forms(morphing_sheet(), "morphing");
  write_exported();
  const char* corpus = std::getenv("DELTAMESH_CORPUS");
  const std::filesystem::path root = corpus ? corpus : DELTAMESH_SOURCE_DIR "/../shared/corpus";
  for (const char* name : {"formats/boat.glb", "formats/kitchen_tsdf_40mm.glb", "formats/Duck.glb",
                           "gltf/cakeBirthday.glb", "gltf/Fox.glb", "gltf/ClearCoatTest.glb",
                           "gltf/MorphStressTest.glb", "gltf/AnimatedMorphSphere.glb"}) {
    if (std::filesystem::exists(root / name))
      write_forms((root / name).string(), std::filesystem::path(name).stem().string());
    else
      std::printf("skipped: no corpus, %s\n", name);
  }
}
