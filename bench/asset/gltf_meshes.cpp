// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "asset/gltf_meshes.h"

#include <cstring>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "base/try.h"
#include "document/compact.h"
#include "document/save.h"
#include "io/gltf/accessor.h"
#include "io/gltf/structure.h"
#include "io/gltf/triangles.h"
#include "support/vertex_picker.h"

namespace deltamesh::bench {
namespace {

using gltf::Document;
using gltf::Json;

Error invalid_asset(const char* message) { return {.code = ErrorCode::kInvalidFile, .message = message}; }

/// The members that say which triangles a primitive has.
Json without_looks(const Json& primitive) {
  Json plain = Json::object();
  for (const char* key : {"mode", "attributes", "indices", "targets"})
    if (const Json* member = gltf::find(primitive, key)) plain[key] = *member;
  return plain;
}

/// A mesh of its distinct primitives, without materials.
Json without_looks(const Json& mesh, bool) {
  Json primitives = Json::array();
  std::set<std::string> known;
  for (const Json& primitive : mesh["primitives"]) {
    Json plain = without_looks(primitive);
    if (known.insert(plain.dump()).second) primitives.push_back(std::move(plain));
  }
  return {{"primitives", std::move(primitives)}};
}

/// A GLB that shows `mesh` alone.
Result<std::vector<std::byte>> single_mesh_asset(std::span<const std::byte> bytes, const GltfIo& io,
                                                 const Json& mesh) {
  DELTAMESH_TRY(Document document, gltf::load_document(bytes, io.resolve));
  Json& json = document.json;
  for (const char* key : {"materials", "textures", "images", "samplers", "skins", "animations", "cameras",
                          "extensions", "extensionsUsed", "extensionsRequired"})
    json.erase(key);
  json["meshes"] = Json::array({mesh});
  json["nodes"] = Json::array({Json{{"mesh", 0}}});
  json["scenes"] = Json::array({Json{{"nodes", Json::array({0})}}});
  json["scene"] = 0;
  document.glb_chunks.clear();
  DELTAMESH_CHECK(gltf::compact_document(document));
  DELTAMESH_TRY(GltfOutput output, gltf::save_document(std::move(document), {}, {}));
  return std::move(output.asset);
}

/// Rows of an accessor, packed.
Result<std::vector<std::byte>> dense_rows(const gltf::AccessorRows& rows) {
  std::vector<std::byte> dense;
  for (std::uint64_t i = 0; i < rows.shape().count; ++i) {
    const auto row = rows.row(i);
    dense.insert(dense.end(), row.begin(), row.end());
  }
  return dense;
}

/// Whether the primitive was read; false where it is no list of triangles with float positions.
Result<bool> read_primitive(const Document& document, const Json& primitive, Primitive& result) {
  DELTAMESH_TRY(const auto triangles, gltf::triangle_primitive(primitive, {}));
  if (!triangles || triangles->mode != gltf::TriangleMode::kList) return false;
  DELTAMESH_TRY(const auto rows, gltf::read_accessor(document, triangles->position, 0));
  if (!rows || rows->shape().type != ComponentType::kF32 || rows->shape().components != 3) return false;
  Mesh mesh;
  DELTAMESH_TRY(const auto positions, dense_rows(*rows));
  mesh.positions.resize(positions.size() / sizeof(float));
  std::memcpy(mesh.positions.data(), positions.data(), positions.size());
  std::optional<gltf::AccessorRows> indices;
  if (triangles->indices) {
    DELTAMESH_TRY(indices, gltf::read_accessor(document, *triangles->indices, 0));
    if (!indices) return invalid_asset("indices are not plain");
  }
  DELTAMESH_TRY(mesh.triangles,
                gltf::triangle_corners(*triangles, mesh.vertex_count(), indices ? &*indices : nullptr));
  if (mesh.triangles.empty()) return false;
  for (const auto& [semantic, accessor] : primitive["attributes"].items()) {
    if (semantic == "POSITION") continue;
    DELTAMESH_TRY(const auto attribute,
                  gltf::read_accessor(document, accessor.get<std::size_t>(), mesh.vertex_count()));
    if (!attribute || attribute->shape().count != mesh.vertex_count())
      return invalid_asset("an attribute is not plain");
    DELTAMESH_TRY(auto values, dense_rows(*attribute));
    mesh.attributes.push_back({.kind = kind_of(semantic),
                               .type = attribute->shape().type,
                               .components = attribute->shape().components,
                               .normalized = attribute->shape().normalized,
                               .name = semantic,
                               .values = std::move(values),
                               .linear = kind_of(semantic) == AttributeKind::kColor});
  }
  result.has_targets = gltf::array_size(primitive, "targets") != 0;
  VertexPicker picker(mesh, !result.has_targets);
  for (const std::uint32_t v : mesh.triangles) picker.add_corner(v);
  result.mesh = picker.take();
  return true;
}

/// Adds each accessor of `numbers` that is not known yet. Errors: stored_bytes()'s.
Result<void> add_plain(const Document& document, const Json& numbers, std::set<std::size_t>& known,
                       std::uint64_t& bytes) {
  for (const Json& accessor : numbers) {
    if (!known.insert(accessor.get<std::size_t>()).second) continue;
    DELTAMESH_TRY(const std::uint64_t plain, gltf::stored_bytes(document, accessor.get<std::size_t>()));
    bytes += plain;
  }
  return {};
}

Result<std::uint64_t> morph_bytes(const Document& document, const Json& mesh) {
  std::set<std::size_t> known;
  std::uint64_t bytes = 0;
  for (const Json& primitive : mesh["primitives"])
    if (const Json* targets = gltf::find(primitive, "targets"))
      for (const Json& target : *targets) DELTAMESH_CHECK(add_plain(document, target, known, bytes));
  return bytes;
}

}  // namespace

Result<Asset> meshes_of_asset(std::span<const std::byte> bytes, const GltfIo& io) {
  DELTAMESH_TRY(const Document document, gltf::load_document(bytes, io.resolve));
  Asset asset;
  std::set<std::string> known;
  if (gltf::array_size(document.json, "meshes") == 0) return asset;
  for (const Json& full : document.json["meshes"]) {
    const Json mesh = without_looks(full, true);
    if (!known.insert(mesh.dump()).second) continue;
    AssetMesh result;
    for (const Json& json : mesh["primitives"]) {
      Primitive primitive;
      DELTAMESH_TRY(const bool read, read_primitive(document, json, primitive));
      if (!read) continue;
      asset.vertices += primitive.mesh.vertex_count();
      result.primitives.push_back(std::move(primitive));
    }
    if (result.primitives.empty()) continue;
    DELTAMESH_TRY(result.morph_bytes, morph_bytes(document, mesh));
    DELTAMESH_TRY(result.asset, single_mesh_asset(bytes, io, mesh));
    asset.meshes.push_back(std::move(result));
  }
  return asset;
}

Result<PackedAsset> take_packed_apart(std::span<const std::byte> bytes) {
  DELTAMESH_TRY(const Document document, gltf::load_document(bytes, {}));
  PackedAsset result;
  std::set<std::uint64_t> views;
  std::set<std::size_t> attributes;
  for (const Json& mesh : document.json["meshes"]) {
    DELTAMESH_TRY(const std::uint64_t morph, morph_bytes(document, mesh));
    result.morph_bytes += morph;
    for (const Json& primitive : mesh["primitives"]) {
      DELTAMESH_CHECK(add_plain(document, primitive["attributes"], attributes, result.plain_bytes));
      const Json* extensions = gltf::find(primitive, "extensions");
      const Json* extension = extensions ? gltf::find(*extensions, gltf::kExtensionName) : nullptr;
      if (extension == nullptr) {  // packing would not have made it smaller
        if (const Json* indices = gltf::find(primitive, "indices"))
          DELTAMESH_CHECK(add_plain(document, Json::array({*indices}), attributes, result.plain_bytes));
        continue;
      }
      const auto view = (*extension)["bufferView"].get<std::uint64_t>();
      if (!views.insert(view).second) continue;
      DELTAMESH_TRY(const auto stream, gltf::view_bytes(document, view));
      if (!stream) return invalid_asset("a stream is not plain");
      result.streams.emplace_back(stream->bytes.begin(), stream->bytes.end());
    }
  }
  return result;
}

}  // namespace deltamesh::bench
