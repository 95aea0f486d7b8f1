// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// glTF and GLB: one node, one mesh, one primitive. The origin becomes the node's translation.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <utility>

#include "accessor.h"
#include "base/byte_writer.h"
#include "base/try.h"
#include "base/vec3.h"
#include "io/formats.h"
#include "io/vertex_text.h"

namespace deltamesh {
namespace {

using gltf::Json;

class GltfBuilder {
 public:
  explicit GltfBuilder(const MeshView& mesh) : mesh_(mesh) {}

  gltf::Document build() {
    if (mesh_.vertex_count() == 0) return std::move(document_);  // an accessor cannot be empty
    add_positions();
    for (const AttributeView& attribute : mesh_.attributes) add_attribute(attribute);
    add_triangles();
    Json node{{"mesh", 0}};
    if (has_origin(mesh_)) node["translation"] = mesh_.origin;
    Json& json = document_.json;
    json["meshes"] = Json::array({{{"primitives", Json::array({std::move(primitive_)})}}});
    json["nodes"] = Json::array({std::move(node)});
    json["scenes"] = Json::array({{{"nodes", Json::array({0})}}});
    json["scene"] = 0;
    json["buffers"] = Json::array({{{"byteLength", out_.size()}}});
    gltf::Buffer& buffer = document_.buffers.emplace_back();
    buffer.owned = out_.take();
    buffer.bytes = buffer.owned;
    return std::move(document_);
  }

 private:
  /// Opens a view and an accessor at the end of the buffer; the values follow.
  Json begin(ComponentType type, std::uint8_t components, std::size_t count, bool indices) {
    constexpr std::array<const char*, 4> kTypes{"SCALAR", "VEC2", "VEC3", "VEC4"};
    constexpr int kVertexAttributes = 34962;
    constexpr int kVertexIndices = 34963;
    const std::size_t size = components * component_size(type);
    Json view{{"buffer", 0}, {"byteOffset", out_.size()}};
    // Vertex attributes begin at multiples of 4 (glTF 2.0, 3.6.2.4).
    if (!indices && size % 4 != 0) view["byteStride"] = (size + 3) / 4 * 4;
    view["target"] = indices ? kVertexIndices : kVertexAttributes;
    Json& views = document_.json["bufferViews"];
    views.push_back(std::move(view));
    return Json{{"bufferView", views.size() - 1},
                {"componentType", gltf::gltf_component_type(type)},
                {"count", count},
                {"type", kTypes[components - 1U]}};
  }

  std::size_t end(Json accessor) {
    pad();
    Json& view = document_.json["bufferViews"].back();
    view["byteLength"] = out_.size() - view["byteOffset"].get<std::size_t>();
    Json& accessors = document_.json["accessors"];
    accessors.push_back(std::move(accessor));
    return accessors.size() - 1;
  }

  Json begin(ComponentType type, std::uint8_t components) {
    return begin(type, components, mesh_.vertex_count(), false);
  }

  void pad() {
    while (out_.size() % 4 != 0) out_.write(std::uint8_t{0});
  }

  void add_positions() {
    Json accessor = begin(ComponentType::kF32, 3);
    Vec3 min;
    Vec3 max;
    min.fill(std::numeric_limits<double>::infinity());
    max.fill(-std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < mesh_.positions.size(); ++i) {
      out_.write(mesh_.positions[i]);
      const auto value = static_cast<double>(mesh_.positions[i]);
      min[i % 3] = std::fmin(min[i % 3], value);
      max[i % 3] = std::fmax(max[i % 3], value);
    }
    accessor["min"] = min;
    accessor["max"] = max;
    primitive_["attributes"]["POSITION"] = end(std::move(accessor));
  }

  void add_attribute(const AttributeView& attribute) {
    switch (attribute.kind) {
      case AttributeKind::kNormal:
        if (attribute.components == 3 && !primitive_["attributes"].contains("NORMAL"))
          return add_normals(attribute);
        break;
      case AttributeKind::kColor:
        if (attribute.components == 3 || attribute.components == 4) return add_colors(attribute);
        break;
      case AttributeKind::kUv:
        if (attribute.components == 2) return add_uvs(attribute);
        break;
      case AttributeKind::kTangent:
        if (attribute.components == 4 && !primitive_["attributes"].contains("TANGENT"))
          return add_tangents(attribute);
        break;
      case AttributeKind::kJoints:
        if (attribute.components == 4 && is_natural(attribute.type))
          return add_values(attribute, attribute.type, false, "JOINTS_" + std::to_string(joints_++));
        break;
      case AttributeKind::kWeights:
        if (attribute.components == 4) return add_weights(attribute);
        break;
      case AttributeKind::kGeneric:
        break;
    }
    add_generic(attribute);
  }

  static bool is_natural(ComponentType type) noexcept {
    return type == ComponentType::kU8 || type == ComponentType::kU16;
  }

  /// Unit length is the law in glTF (3.7.2.1): others are scaled to it; zero or NaN become `otherwise`.
  Vec3 unit_value(const AttributeView& attribute, std::size_t vertex, const Vec3& otherwise) const {
    constexpr double kTolerance = 1e-4;
    Vec3 value{};
    for (std::size_t k = 0; k < 3; ++k) value[k] = attribute_value(attribute, vertex, k);
    const double size = length(value);
    if (!(size > 0) || !std::isfinite(size)) return otherwise;
    return std::fabs(size - 1) > kTolerance ? (1 / size) * value : value;
  }

  void add_normals(const AttributeView& attribute) {
    Json accessor = begin(ComponentType::kF32, 3);
    for (std::size_t v = 0; v < mesh_.vertex_count(); ++v)
      for (const double value : unit_value(attribute, v, {0, 0, 1})) out_.write(to_float(value));
    primitive_["attributes"]["NORMAL"] = end(std::move(accessor));
  }

  /// The fourth component is the side of the bitangent, 1 or -1.
  void add_tangents(const AttributeView& attribute) {
    Json accessor = begin(ComponentType::kF32, 4);
    for (std::size_t v = 0; v < mesh_.vertex_count(); ++v) {
      for (const double value : unit_value(attribute, v, {1, 0, 0})) out_.write(to_float(value));
      out_.write(attribute_value(attribute, v, 3) < 0 ? -1.0F : 1.0F);
    }
    primitive_["attributes"]["TANGENT"] = end(std::move(accessor));
  }

  void add_colors(const AttributeView& attribute) {
    const bool integer = is_natural(attribute.type);
    add_values(attribute, integer ? attribute.type : ComponentType::kF32, integer,
               "COLOR_" + std::to_string(colors_++));
  }

  void add_weights(const AttributeView& attribute) {
    const bool integer = is_natural(attribute.type) && attribute.normalized;
    add_values(attribute, integer ? attribute.type : ComponentType::kF32, integer,
               "WEIGHTS_" + std::to_string(weights_++));
  }

  void add_uvs(const AttributeView& attribute) {
    add_values(attribute, ComponentType::kF32, false, "TEXCOORD_" + std::to_string(uvs_++));
  }

  /// glTF has no 64-bit components, and forbids 32-bit integers to custom attributes (3.7.2.1): those are
  /// left out, as are shapes that no accessor has.
  void add_generic(const AttributeView& attribute) {
    const bool type_fits = component_size(attribute.type) <= 2 || attribute.type == ComponentType::kF32;
    if (!type_fits || attribute.components > 4) return;
    std::string name(attribute.name.empty() ? "ATTRIBUTE" : attribute.name);
    if (!name.starts_with('_')) name.insert(0, 1, '_');
    while (primitive_["attributes"].contains(name)) name += '_';
    const bool integer = attribute.type != ComponentType::kF32;
    add_values(attribute, attribute.type, attribute.normalized && integer, name);
  }

  /// Values as they are where `type` is the attribute's own, else as real numbers.
  void add_values(const AttributeView& attribute, ComponentType type, bool normalized,
                  const std::string& name) {
    Json accessor = begin(type, attribute.components);
    if (normalized) accessor["normalized"] = true;
    const std::size_t size = component_size(attribute.type);
    for (std::size_t v = 0; v < mesh_.vertex_count(); ++v) {
      for (std::size_t c = 0; c < attribute.components; ++c) {
        if (type == ComponentType::kF32 && type != attribute.type) {
          out_.write(to_float(attribute_value(attribute, v, c)));
          continue;
        }
        const std::byte* const from = attribute.values.data() + (v * attribute.components + c) * size;
        with_component(type, [&](auto value) {
          std::memcpy(&value, from, sizeof value);
          out_.write(value);
        });
      }
      pad();
    }
    primitive_["attributes"][name] = end(std::move(accessor));
  }

  void add_triangles() {
    if (mesh_.triangles.empty()) {
      primitive_["mode"] = 0;  // points
      return;
    }
    // 65535 itself restarts a primitive on some devices, so that index may not occur (glTF 2.0, 3.7.2.1).
    const bool small = mesh_.vertex_count() <= std::numeric_limits<std::uint16_t>::max();
    Json accessor = begin(small ? ComponentType::kU16 : ComponentType::kU32, 1, mesh_.triangles.size(), true);
    for (const std::uint32_t index : mesh_.triangles) {
      if (small)
        out_.write(static_cast<std::uint16_t>(index));
      else
        out_.write(index);
    }
    primitive_["indices"] = end(std::move(accessor));
  }

  const MeshView& mesh_;
  gltf::Document document_{
      .json = {{"asset", {{"version", "2.0"}, {"generator", "deltamesh"}}}}, .buffers = {}, .glb_chunks = {}};
  Json primitive_{{"attributes", Json::object()}};
  ByteWriter out_;
  int colors_ = 0;
  int uvs_ = 0;
  int joints_ = 0;
  int weights_ = 0;
};

}  // namespace

Result<std::vector<std::byte>> write_gltf(const MeshView& mesh, bool binary) {
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    if (!std::isfinite(mesh.positions[i]))
      return Error{.code = ErrorCode::kInvalidMesh,
                   .message = "glTF cannot hold a coordinate that is not finite",
                   .where_kind = WhereKind::kVertex,
                   .where = i / 3};
  GltfIo io;
  io.container = binary ? GltfContainer::kGlb : GltfContainer::kGltf;
  DELTAMESH_TRY(GltfOutput output, gltf::save_document(GltfBuilder(mesh).build(), io, {}));
  return std::move(output.asset);
}

}  // namespace deltamesh
