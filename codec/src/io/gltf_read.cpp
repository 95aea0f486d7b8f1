// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// glTF: all triangle primitives of all placed meshes as one mesh. Instances are repeated, so that a small
// file may stand for a large mesh; what may come of it is limited to kFreeElements + kElementsPerByte *
// (bytes read).
#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "accessor.h"
#include "base/checked.h"
#include "base/try.h"
#include "io/components.h"
#include "io/formats.h"
#include "io/gltf_accessor.h"
#include "io/gltf_attributes.h"
#include "io/gltf_scene.h"
#include "io/io_error.h"
#include "io/origin.h"

namespace deltamesh {
namespace {

using gltf::Json;

constexpr std::uint64_t kFreeElements = std::uint64_t{1} << 20;
constexpr std::uint64_t kElementsPerByte = 16;

// glTF's numbers for "mode".
constexpr std::uint64_t kTriangleList = 4;
constexpr std::uint64_t kTriangleStrip = 5;
constexpr std::uint64_t kTriangleFan = 6;

/// One primitive of a placed mesh.
struct Part {
  std::size_t set = 0;
  std::uint64_t mode = kTriangleList;
  std::optional<std::size_t> indices;  ///< their accessor
};

/// Required extensions that leave the accessors' meaning alone.
bool is_harmless(std::string_view extension) noexcept {
  constexpr std::array<std::string_view, 8> kPrefixes{
      "KHR_materials_", "KHR_texture_",          "KHR_lights_", "EXT_lights_",
      "EXT_texture_",   "KHR_mesh_quantization", "KHR_xmp",     "KHR_animation_"};
  return std::any_of(kPrefixes.begin(), kPrefixes.end(),
                     [extension](std::string_view prefix) { return extension.starts_with(prefix); });
}

Result<void> check_extensions(const Json& asset) {
  for (std::size_t i = 0; i < gltf::array_size(asset, "extensionsRequired"); ++i) {
    const auto& name = asset["extensionsRequired"][i].get_ref<const std::string&>();
    if (name == gltf::kExtensionName)
      return invalid_file("glTF: the file is packed by deltamesh; unpack it first");
    if (name == "KHR_draco_mesh_compression")
      return invalid_file("glTF: meshes compressed by Draco are not supported");
    if (name == "EXT_meshopt_compression" || name == "KHR_meshopt_compression")
      return invalid_file("glTF: buffers compressed by meshoptimizer are not supported");
    if (!is_harmless(name)) return invalid_file("glTF: the file requires an extension that is not supported");
  }
  return {};
}

class Assembly {
 public:
  Assembly(const gltf::Document& document, const std::vector<GltfPlacement>& placements)
      : document_(document),
        placements_(placements),
        limit_(saturating_add(kFreeElements, saturating_mul(kElementsPerByte, document.input_bytes))) {}

  Result<Imported> build() {
    for (const GltfPlacement& placement : placements_) DELTAMESH_CHECK(collect(placement));
    DELTAMESH_CHECK(read_positions());
    DELTAMESH_TRY(imported_.mesh.attributes,
                  merge_attributes(document_, sets_, vertices_, imported_.notes.dropped_attributes));
    for (const Part& part : parts_) DELTAMESH_CHECK(read_triangles(part));
    add_missing_normals(sets_, imported_.mesh);
    return std::move(imported_);
  }

 private:
  /// Lists the parts of a placed mesh; primitives with the same attributes share their vertices.
  Result<void> collect(const GltfPlacement& placement) {
    constexpr Error kBadMode = invalid_file("glTF: a primitive of unknown mode");
    std::map<GltfSemantics, std::size_t> known;
    for (const Json& primitive : document_.json["meshes"][placement.mesh]["primitives"]) {
      DELTAMESH_TRY(const std::uint64_t mode,
                    gltf::unsigned_member(primitive, "mode", kTriangleList, kTriangleFan, kBadMode));
      const auto semantics = primitive["attributes"].get<GltfSemantics>();
      const auto position = semantics.find("POSITION");
      if (mode < kTriangleList || position == semantics.end()) {
        ++imported_.notes.other_primitives;
        continue;
      }
      const auto [set, is_new] = known.emplace(semantics, sets_.size());
      if (is_new) {
        DELTAMESH_TRY(const gltf::AccessorShape shape, needed_shape(document_, position->second));
        if (shape.components != 3) return invalid_file("glTF: POSITION is not a VEC3");
        DELTAMESH_CHECK(reserve(vertices_, shape.count));
        sets_.push_back({semantics, &placement.transform, vertices_ - shape.count, shape.count});
      }
      Part part{.set = set->second, .mode = mode, .indices = std::nullopt};
      std::uint64_t corners = sets_[part.set].count;
      if (const Json* const indices = gltf::find(primitive, "indices")) {
        part.indices = indices->get<std::size_t>();
        DELTAMESH_TRY(const gltf::AccessorShape shape, needed_shape(document_, *part.indices));
        corners = shape.count;
      }
      DELTAMESH_CHECK(reserve(corners_, corners));
      parts_.push_back(part);
    }
    return {};
  }

  /// Adds to a count that must stay within the limit: before anything is allocated.
  Result<void> reserve(std::uint64_t& total, std::uint64_t more) const {
    total = saturating_add(total, more);
    if (total > limit_ || total > std::numeric_limits<std::uint32_t>::max())
      return invalid_file("glTF: the file states or repeats far more vertices than its size suggests");
    return {};
  }

  Result<void> read_positions() {
    std::vector<double> coordinates(vertices_ * 3);
    for (const GltfVertexSet& set : sets_) {
      DELTAMESH_TRY(const gltf::AccessorRows rows, needed_rows(document_, set.semantics.at("POSITION")));
      const gltf::AccessorShape& shape = rows.shape();
      const bool moved = !set.transform->is_identity();
      for (std::uint64_t v = 0; v < set.count; ++v) {
        Vec3 point{};
        for (std::size_t k = 0; k < 3; ++k)
          point[k] = load_normalized(shape.type, shape.normalized,
                                     rows.row(v).data() + k * component_size(shape.type));
        if (moved) point = set.transform->point(point);
        std::memcpy(&coordinates[3 * (set.first + v)], point.data(), sizeof point);
      }
    }
    PlacedPositions placed = place_origin(coordinates);
    imported_.mesh.origin = placed.origin;
    imported_.mesh.positions = std::move(placed.positions);
    return {};
  }

  Result<void> read_triangles(const Part& part) {
    const GltfVertexSet& set = sets_[part.set];
    std::vector<std::uint32_t> corners;
    if (part.indices) {
      DELTAMESH_TRY(corners, read_indices(document_, *part.indices, set.count));
    } else {
      for (std::uint32_t v = 0; v < set.count; ++v) corners.push_back(v);
    }
    const bool mirrored = set.transform->determinant() < 0;
    const auto add = [&](std::size_t a, std::size_t b, std::size_t c) {
      if (mirrored) std::swap(b, c);
      for (const std::size_t i : {a, b, c})
        imported_.mesh.triangles.push_back(static_cast<std::uint32_t>(set.first) + corners[i]);
    };
    // Corner orders of glTF 2.0, 3.7.2.1.
    const bool list = part.mode == kTriangleList;
    const bool strip = part.mode == kTriangleStrip;
    if (list && corners.size() % 3 != 0) ++imported_.notes.dropped_faces;
    for (std::size_t i = 0; i + 2 < corners.size(); i += list ? 3 : 1) {
      if (list)
        add(i, i + 1, i + 2);
      else if (strip)
        add(i, i + 1 + i % 2, i + 2 - i % 2);
      else
        add(i + 1, i + 2, 0);
    }
    return {};
  }

  const gltf::Document& document_;
  const std::vector<GltfPlacement>& placements_;
  std::uint64_t limit_;
  std::vector<GltfVertexSet> sets_;
  std::vector<Part> parts_;
  std::uint64_t vertices_ = 0;
  std::uint64_t corners_ = 0;
  Imported imported_;
};

}  // namespace

Result<Imported> read_gltf(std::span<const std::byte> bytes, std::string_view folder) {
  GltfIo io;
  if (!folder.empty())
    io.resolve = [folder](std::string_view path) {
      return read_file(std::string(folder).append("/").append(path));
    };
  DELTAMESH_TRY(const gltf::Document document, gltf::load_document(bytes, io));
  DELTAMESH_CHECK(check_extensions(document.json));
  DELTAMESH_TRY(const std::vector<GltfPlacement> placements, place_meshes(document.json));
  return Assembly(document, placements).build();
}

}  // namespace deltamesh
