// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// glTF and GLB: one node, one mesh, one primitive for each group of faces. The origin becomes the node's
// translation.
#include <tiny_gltf.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <span>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "base/byte_writer.h"
#include "base/numbers/vec3.h"
#include "io/formats.h"
#include "io/gltf/accessor.h"
#include "io/gltf/content/narrow.h"
#include "io/names.h"
#include "io/text/vertices.h"

namespace deltamesh {
namespace {

class GltfBuilder {
 public:
  GltfBuilder(const MeshView& mesh, WriteReport& report) : mesh_(mesh), report_(report) {}

  tinygltf::Model build() {
    model_.asset.version = "2.0";
    model_.asset.generator = "deltamesh";
    if (mesh_.vertex_count() == 0) return std::move(model_);  // an accessor cannot be empty
    add_positions();
    for (const AttributeView& attribute : mesh_.attributes) add_attribute(attribute);
    model_.meshes.emplace_back().primitives = primitives();
    tinygltf::Node& node = model_.nodes.emplace_back();
    node.mesh = 0;
    if (has_origin(mesh_)) node.translation.assign(mesh_.origin.begin(), mesh_.origin.end());
    model_.scenes.emplace_back().nodes = {0};
    model_.defaultScene = 0;
    std::vector<unsigned char>& buffer = model_.buffers.emplace_back().data;
    buffer.resize(out_.size());
    std::memcpy(buffer.data(), out_.bytes().data(), buffer.size());
    return std::move(model_);
  }

 private:
  /// Opens a view and an accessor at the end of the buffer; the values follow.
  tinygltf::Accessor begin(ComponentType type, std::uint8_t components, bool indices) {
    const std::size_t size = components * component_size(type);
    tinygltf::BufferView& view = model_.bufferViews.emplace_back();
    view.buffer = 0;
    view.byteOffset = out_.size();
    // Vertex attributes begin at multiples of 4 (glTF 2.0, 3.6.2.4).
    view.byteStride = indices || size % 4 == 0 ? 0 : (size + 3) / 4 * 4;
    view.target = indices ? TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER : TINYGLTF_TARGET_ARRAY_BUFFER;
    tinygltf::Accessor accessor;
    accessor.bufferView = static_cast<int>(model_.bufferViews.size()) - 1;
    accessor.count = mesh_.vertex_count();
    accessor.componentType = gltf::gltf_component_type(type);
    constexpr std::array<int, 4> kTypes{TINYGLTF_TYPE_SCALAR, TINYGLTF_TYPE_VEC2, TINYGLTF_TYPE_VEC3,
                                        TINYGLTF_TYPE_VEC4};
    accessor.type = kTypes[components - 1U];
    return accessor;
  }

  int end(tinygltf::Accessor accessor) {
    pad();
    tinygltf::BufferView& view = model_.bufferViews.back();
    view.byteLength = out_.size() - view.byteOffset;
    model_.accessors.push_back(std::move(accessor));
    return static_cast<int>(model_.accessors.size()) - 1;
  }

  void pad() {
    while (out_.size() % 4 != 0) out_.write(std::uint8_t{0});
  }

  void add_positions() {
    tinygltf::Accessor accessor = begin(ComponentType::kF32, 3, false);
    accessor.minValues.assign(3, std::numeric_limits<double>::infinity());
    accessor.maxValues.assign(3, -std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < mesh_.positions.size(); ++i) {
      out_.write(mesh_.positions[i]);
      const auto value = static_cast<double>(mesh_.positions[i]);
      accessor.minValues[i % 3] = std::fmin(accessor.minValues[i % 3], value);
      accessor.maxValues[i % 3] = std::fmax(accessor.maxValues[i % 3], value);
    }
    primitive_.attributes["POSITION"] = end(std::move(accessor));
  }

  void add_attribute(const AttributeView& attribute) {
    const std::size_t components = attribute.components;
    const bool natural = attribute.type == ComponentType::kU8 || attribute.type == ComponentType::kU16;
    const auto add_set = [&](const char* prefix, int& sets, bool keeps_type, bool normalized) {
      add_values(attribute, keeps_type ? attribute.type : ComponentType::kF32, normalized,
                 prefix + std::to_string(sets++));
    };
    switch (attribute.kind) {
      case AttributeKind::kNormal:
        if (components == 3 && !primitive_.attributes.contains("NORMAL"))
          return add_directions(attribute, "NORMAL", {0, 0, 1});
        break;
      case AttributeKind::kColor:
        if (components == 3 || components == 4) return add_set("COLOR_", colors_, natural, natural);
        break;
      case AttributeKind::kUv:
        if (components == 2) return add_set("TEXCOORD_", uvs_, false, false);
        break;
      case AttributeKind::kTangent:
        if (components == 4 && !primitive_.attributes.contains("TANGENT"))
          return add_directions(attribute, "TANGENT", {1, 0, 0});
        break;
      case AttributeKind::kJoints:
        if (components == 4 && natural) return add_set("JOINTS_", joints_, true, false);
        break;
      case AttributeKind::kWeights:
        if (components == 4) {
          const bool integer = natural && attribute.normalized;
          return add_set("WEIGHTS_", weights_, integer, integer);
        }
        break;
      case AttributeKind::kGeneric:
        break;
    }
    add_generic(attribute);
  }

  /// A fourth component is the side of the bitangent, 1 or -1.
  void add_directions(const AttributeView& attribute, const char* name, const Vec3& otherwise) {
    tinygltf::Accessor accessor = begin(ComponentType::kF32, attribute.components, false);
    for (std::size_t v = 0; v < mesh_.vertex_count(); ++v) {
      for (const double value : unit_direction(attribute, v, otherwise)) out_.write(to_float(value));
      if (attribute.components == 4) out_.write(attribute_value(attribute, v, 3) < 0 ? -1.0F : 1.0F);
    }
    primitive_.attributes[name] = end(std::move(accessor));
  }

  /// glTF forbids 32-bit integers to custom attributes (3.7.2.1). Shapes that no accessor has are left out.
  void add_generic(const AttributeView& attribute) {
    if (attribute.components > 4)
      return report_.leave_out(LeftOutKind::kVertexValues, attribute.name, mesh_.vertex_count());
    std::string name((attribute.name.starts_with('_') ? "" : "_") + std::string(attribute.name));
    while (primitive_.attributes.contains(name)) name += '_';
    std::vector<Attribute> narrowed;
    const AttributeView values = with_gltf_type(attribute, narrowed, report_);
    add_values(values, values.type, values.normalized && values.type != ComponentType::kF32, name);
  }

  /// Values as they are where `type` is the attribute's own, else as real numbers.
  void add_values(const AttributeView& attribute, ComponentType type, bool normalized,
                  const std::string& name) {
    tinygltf::Accessor accessor = begin(type, attribute.components, false);
    accessor.normalized = normalized;
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
    primitive_.attributes[name] = end(std::move(accessor));
  }

  /// One for every group of faces, all with the same vertices.
  std::vector<tinygltf::Primitive> primitives() {
    primitive_.mode = mesh_.triangles.empty() ? TINYGLTF_MODE_POINTS : TINYGLTF_MODE_TRIANGLES;
    if (mesh_.triangles.empty()) return {primitive_};
    const std::vector<GroupName> names = distinct_names(mesh_);
    const auto corners = corners_by_group(mesh_, std::max<std::size_t>(names.size(), 1));
    std::vector<tinygltf::Primitive> made;
    for (std::size_t g = 0; g < corners.size(); ++g) {
      if (corners[g].empty()) continue;
      made.push_back(primitive_);
      made.back().indices = add_indices(corners[g]);
      if (!names.empty()) name_primitive(names[g], made.back());
    }
    return made;
  }

  /// glTF names materials, but no primitives: object and group go to extras.
  void name_primitive(const GroupName& name, tinygltf::Primitive& primitive) {
    tinygltf::Value::Object extras;
    if (!name.object.empty()) extras["object"] = tinygltf::Value(name.object);
    if (!name.group.empty()) extras["group"] = tinygltf::Value(name.group);
    if (!extras.empty()) primitive.extras = tinygltf::Value(extras);
    if (name.material.empty()) return;
    const auto [known, is_new] = materials_.emplace(name.material, static_cast<int>(materials_.size()));
    if (is_new) model_.materials.emplace_back().name = name.material;
    primitive.material = known->second;
  }

  int add_indices(std::span<const std::uint32_t> corners) {
    // 65535 itself restarts a primitive on some devices, so that index may not occur (glTF 2.0, 3.7.2.1).
    const bool small = mesh_.vertex_count() <= std::numeric_limits<std::uint16_t>::max();
    tinygltf::Accessor accessor = begin(small ? ComponentType::kU16 : ComponentType::kU32, 1, true);
    accessor.count = corners.size();
    for (const std::uint32_t index : corners) {
      if (small)
        out_.write(static_cast<std::uint16_t>(index));
      else
        out_.write(index);
    }
    return end(std::move(accessor));
  }

  const MeshView& mesh_;
  WriteReport& report_;
  tinygltf::Model model_;
  tinygltf::Primitive primitive_;
  std::map<std::string, int> materials_;
  ByteWriter out_;
  int colors_ = 0;
  int uvs_ = 0;
  int joints_ = 0;
  int weights_ = 0;
};

}  // namespace

Result<std::vector<std::byte>> write_gltf(const MeshView& mesh, bool binary, WriteReport& report) {
  tinygltf::Model model = GltfBuilder(mesh, report).build();
  constexpr std::size_t kDescription = std::size_t{1} << 20;  // more than the JSON of one primitive takes
  if (binary && !model.buffers.empty() &&
      model.buffers[0].data.size() > std::numeric_limits<std::uint32_t>::max() - kDescription)
    return Error{.code = ErrorCode::kLimitExceeded, .message = "a GLB file cannot be larger than 4 GiB"};
  std::ostringstream stream;
  tinygltf::TinyGLTF().WriteGltfSceneToStream(&model, stream, false, binary);
  const std::string text = stream.str();
  const auto bytes = std::as_bytes(std::span(text));
  return std::vector<std::byte>(bytes.begin(), bytes.end());
}

}  // namespace deltamesh
