// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// glTF: all triangle primitives of all placed meshes as one mesh. Instances are repeated, so that a small
// file may stand for a large mesh; what may come of it is limited to kFreeElements + kElementsPerByte *
// (bytes read).
#include <algorithm>
#include <cstring>
#include <limits>
#include <map>
#include <string>
#include <utility>

#include "base/checked.h"
#include "base/try.h"
#include "deltamesh/io.h"
#include "io/formats.h"
#include "io/gltf/attributes.h"
#include "io/gltf/content/groups.h"
#include "io/gltf/content/texture_transform.h"
#include "io/gltf/document.h"
#include "io/gltf/scene.h"
#include "io/gltf/structure.h"
#include "io/gltf/triangles.h"
#include "io/gltf/uri.h"
#include "io/io_error.h"
#include "io/origin.h"

namespace deltamesh {
namespace gltf {
namespace {

/// Values of attributes, each of some 50 bytes until it is read. A thousand small trees in a forest have
/// fewer.
constexpr std::uint64_t kFreeElements = std::uint64_t{1} << 15;
constexpr std::uint64_t kElementsPerByte = 64;

/// One primitive of a placed mesh.
struct Part {
  TrianglePrimitive primitive;
  std::size_t set = 0;
  std::uint32_t group = 0;
};

/// Tells `report` of materials (their names are kept), textures, skins, animations, cameras, lights and morph
/// targets.
void leave_out_parts(const Json& json, ReadReport& report) {
  // A material of a name alone is what our own writer makes of a group's name.
  std::uint64_t materials = 0;
  if (const Json* const all = find(json, "materials"); all != nullptr && all->is_array())
    for (const Json& material : *all)
      materials += material.is_object() && material.size() <= material.count("name") ? 0 : 1;
  report.leave_out(LeftOutKind::kElements, "materials", materials);
  for (const char* const part : {"textures", "skins", "animations", "cameras"})
    report.leave_out(LeftOutKind::kElements, part, array_size(json, part));
  if (const Json* const extensions = find(json, "extensions"); extensions != nullptr)
    if (const Json* const lights = find(*extensions, "KHR_lights_punctual"); lights != nullptr)
      report.leave_out(LeftOutKind::kElements, "lights", array_size(*lights, "lights"));
  std::uint64_t targets = 0;
  for_each_primitive(json, [&](const Json& primitive, const PrimitiveNumber&) {
    targets += array_size(primitive, "targets");
  });
  report.leave_out(LeftOutKind::kVertexValues, "morph targets", targets);
}

/// Tells `report` of extensions that may say something about meshes and are not understood. Two of those that
/// packing may pass over are among them; the others are about materials, textures and lights, which are left
/// out as a whole.
void leave_out_extensions(const Json& json, ReadReport& report) {
  const Json* const used = find(json, "extensionsUsed");
  for (const Json& entry : used ? *used : Json::array()) {
    const auto& name = entry.get_ref<const std::string&>();
    const bool is_harmless =
        is_harmless_extension(name) && name != "KHR_materials_variants" && name != "KHR_node_visibility";
    if (!is_harmless && name != "EXT_mesh_gpu_instancing")
      report.leave_out(LeftOutKind::kElements, "extension " + name);
  }
}

class Assembly {
 public:
  explicit Assembly(const Document& document)
      : document_(document),
        groups_(document.json),
        limit_(saturating_add(kFreeElements, saturating_mul(kElementsPerByte, document.input_bytes))) {
    std::size_t first = 0;
    for (std::size_t i = 0; i < array_size(document.json, "meshes"); ++i) {
      first_primitive_.push_back(first);
      first += document.json["meshes"][i]["primitives"].size();
    }
  }

  Result<Imported> build(const std::vector<Placement>& placements) {
    for (const Placement& placement : placements) DELTAMESH_CHECK(collect(placement));
    DELTAMESH_CHECK(read_positions());
    DELTAMESH_TRY(imported_.mesh.attributes, merge_attributes(document_, sets_, vertices_, imported_.report));
    for (const Part& part : parts_) DELTAMESH_CHECK(read_triangles(part));
    place_origin(coordinates_, imported_.mesh.triangles, imported_);
    fill_normals();
    groups_.move_into(imported_);
    imported_.report.leave_out(LeftOutKind::kPrimitives, "meshes that the scene does not show",
                               hidden_meshes(document_.json, placements));
    leave_out_parts(document_.json, imported_.report);
    leave_out_extensions(document_.json, imported_.report);
    imported_.report.files = named_files(document_.json);
    return std::move(imported_);
  }

 private:
  /// Lists the parts of a placed mesh; primitives with the same attributes share their vertices.
  Result<void> collect(const Placement& placement) {
    std::map<std::map<std::string, std::size_t>, std::size_t> known;
    PrimitiveNumber number{.number = first_primitive_[placement.mesh], .mesh = placement.mesh};
    for (const Json& json : document_.json["meshes"][placement.mesh]["primitives"]) {
      DELTAMESH_TRY(const auto primitive, triangle_primitive(json, number));
      ++number.number;
      ++number.in_mesh;
      if (!primitive) {
        imported_.report.leave_out(LeftOutKind::kPrimitives, "primitives that are not triangles");
        continue;
      }
      auto semantics = json["attributes"].get<std::map<std::string, std::size_t>>();
      const auto [set, is_new] = known.emplace(semantics, sets_.size());
      if (is_new) {
        DELTAMESH_TRY(const AccessorShape shape, plain_shape(document_, primitive->position));
        if (shape.components != 3) return accessor_error("POSITION is not a VEC3", primitive->position);
        vertices_ = saturating_add(vertices_, shape.count);
        DELTAMESH_CHECK(reserve(values_, saturating_mul(shape.count, semantics.size())));
        sets_.push_back({.semantics = std::move(semantics),
                         .transform = &placement.transform,
                         .first = vertices_ - shape.count,
                         .count = shape.count});
      }
      DELTAMESH_TRY(const std::uint64_t corners, corner_count(*primitive, sets_[set->second].count));
      if (primitive->mode == TriangleMode::kList && corners % 3 != 0)
        imported_.report.leave_out(LeftOutKind::kFaces, "of fewer than three corners");
      DELTAMESH_CHECK(reserve(quarters_, corners / 4 + 1));  // as large as a value
      imported_.report.uv_scale = std::max(imported_.report.uv_scale, uv_scale_of(document_.json, json));
      parts_.push_back({*primitive, set->second, groups_.number_of(json, placement.mesh)});
    }
    return {};
  }

  Result<std::uint64_t> corner_count(const TrianglePrimitive& primitive, std::uint64_t vertices) const {
    if (!primitive.indices) return vertices;
    DELTAMESH_TRY(const AccessorShape shape, plain_shape(document_, *primitive.indices));
    return shape.count;
  }

  /// Adds to a count that must stay within the limit: before anything is allocated.
  Result<void> reserve(std::uint64_t& total, std::uint64_t more) const {
    total = saturating_add(total, more);
    if (total > limit_ || total > std::numeric_limits<std::uint32_t>::max())
      return invalid_file(
          "the file states or repeats more than one of its size may: 64 values for each byte");
    return {};
  }

  Result<void> read_positions() {
    coordinates_.resize(vertices_ * 3);
    for (const VertexSet& set : sets_) {
      DELTAMESH_TRY(const AccessorRows rows, plain_rows(document_, set.semantics.at("POSITION")));
      const bool moved = !set.transform->is_identity();
      for (std::uint64_t v = 0; v < set.count; ++v) {
        Vec3 point = vector_at(rows, v);
        if (moved) point = set.transform->point(point);
        std::memcpy(&coordinates_[3 * (set.first + v)], point.data(), sizeof point);
      }
    }
    return {};
  }

  Result<void> read_triangles(const Part& part) {
    const VertexSet& set = sets_[part.set];
    std::optional<AccessorRows> indices;
    if (part.primitive.indices) {
      DELTAMESH_TRY(indices, plain_rows(document_, *part.primitive.indices));
    }
    DELTAMESH_TRY(auto corners, triangle_corners(part.primitive, set.count, indices ? &*indices : nullptr));
    if (set.transform->determinant() < 0)
      for (std::size_t i = 0; i < corners.size(); i += 3) std::swap(corners[i + 1], corners[i + 2]);
    for (std::uint32_t& corner : corners) corner += static_cast<std::uint32_t>(set.first);
    std::vector<std::uint32_t>& all = imported_.mesh.triangles;
    all.insert(all.end(), corners.begin(), corners.end());
    groups_.add_faces(part.group, corners.size() / 3);
    if (!set.semantics.contains("NORMAL")) bare_.insert(bare_.end(), corners.begin(), corners.end());
    return {};
  }

  /// Vertices of sets without NORMAL get that of the faces around, where others have one.
  void fill_normals() {
    Mesh& mesh = imported_.mesh;
    const auto normals = std::ranges::find(mesh.attributes, AttributeKind::kNormal, &Attribute::kind);
    if (normals != mesh.attributes.end()) write_face_normals(mesh, bare_, normals->values);
  }

  const Document& document_;
  PrimitiveGroups groups_;
  std::uint64_t limit_;
  std::vector<std::size_t> first_primitive_;  ///< by mesh: its number over all meshes
  std::vector<VertexSet> sets_;
  std::vector<Part> parts_;
  std::vector<double> coordinates_;  ///< vertices_ x 3
  std::vector<std::uint32_t> bare_;  ///< corners of the triangles without normals
  std::uint64_t vertices_ = 0;
  std::uint64_t values_ = 0;    ///< of their attributes
  std::uint64_t quarters_ = 0;  ///< of corners
  Imported imported_;
};

/// Extensions that leave geometry alone are harmless; what compresses it is named.
Result<void> check_required_extensions(const Json& json) {
  const Json* required = find(json, "extensionsRequired");
  for (const Json& entry : required ? *required : Json::array()) {
    const auto& name = entry.get_ref<const std::string&>();
    if (name == kExtensionName) return invalid_file("glTF: the file is packed by deltamesh; unpack it first");
    if (name == "KHR_draco_mesh_compression")
      return invalid_file("glTF: meshes compressed by Draco are not supported");
    if (name == "EXT_meshopt_compression" || name == "KHR_meshopt_compression")
      return invalid_file("glTF: buffers compressed by meshoptimizer are not supported");
    if (!is_harmless_extension(name) && name != "EXT_mesh_gpu_instancing")
      return invalid_file("glTF: the file requires an extension that is not supported");
  }
  return {};
}

}  // namespace
}  // namespace gltf

Result<Imported> read_gltf(std::span<const std::byte> bytes, std::string_view folder) {
  const gltf::Resolver resolve = [folder](std::string_view path) -> Result<std::vector<std::byte>> {
    if (folder.empty()) return invalid_file("glTF: a buffer is in another file, and no folder is given");
    return read_file(std::string(folder) + '/' + std::string(path));
  };
  DELTAMESH_TRY(const gltf::Document document, gltf::load_document(bytes, resolve));
  DELTAMESH_CHECK(gltf::check_required_extensions(document.json));
  DELTAMESH_TRY(const std::vector<gltf::Placement> placements, gltf::place_meshes(document));
  return gltf::Assembly(document).build(placements);
}

}  // namespace deltamesh
