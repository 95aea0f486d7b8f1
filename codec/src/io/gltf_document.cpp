// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "io/gltf_document.h"

#include <tiny_gltf.h>

#include <sstream>
#include <utility>

#include "base/try.h"
#include "io/io_error.h"

namespace deltamesh {
namespace {

std::optional<ComponentType> component_type(int gltf) noexcept {
  switch (gltf) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return ComponentType::kI8;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return ComponentType::kU8;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return ComponentType::kI16;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return ComponentType::kU16;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return ComponentType::kU32;
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return ComponentType::kF32;
    default:
      return std::nullopt;
  }
}

int gltf_component_type(ComponentType type) noexcept {
  switch (type) {
    case ComponentType::kI8:
      return TINYGLTF_COMPONENT_TYPE_BYTE;
    case ComponentType::kU8:
      return TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE;
    case ComponentType::kI16:
      return TINYGLTF_COMPONENT_TYPE_SHORT;
    case ComponentType::kU16:
      return TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT;
    case ComponentType::kU32:
      return TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
    default:
      return TINYGLTF_COMPONENT_TYPE_FLOAT;
  }
}

struct Shape {
  int type;
  std::uint8_t components;
  bool matrix;
};
constexpr std::array<Shape, 7> kShapes{{{TINYGLTF_TYPE_SCALAR, 1, false},
                                        {TINYGLTF_TYPE_VEC2, 2, false},
                                        {TINYGLTF_TYPE_VEC3, 3, false},
                                        {TINYGLTF_TYPE_VEC4, 4, false},
                                        {TINYGLTF_TYPE_MAT2, 4, true},
                                        {TINYGLTF_TYPE_MAT3, 9, true},
                                        {TINYGLTF_TYPE_MAT4, 16, true}}};

Result<GltfAccessor> from_tiny(const tinygltf::Accessor& source) {
  const auto type = component_type(source.componentType);
  if (!type) return invalid_file("glTF: an accessor of unknown component type");
  GltfAccessor accessor;
  accessor.view = source.bufferView;
  accessor.offset = source.byteOffset;
  accessor.count = source.count;
  accessor.type = *type;
  accessor.normalized = source.normalized;
  for (const Shape& shape : kShapes) {
    if (shape.type != source.type) continue;
    accessor.components = shape.components;
    accessor.matrix = shape.matrix;
  }
  if (source.sparse.isSparse) {
    const auto index_type = component_type(source.sparse.indices.componentType);
    if (!index_type) return invalid_file("glTF: a sparse accessor with indices of unknown component type");
    accessor.sparse = GltfSparse{.count = source.sparse.count,
                                 .index_view = source.sparse.indices.bufferView,
                                 .index_offset = source.sparse.indices.byteOffset,
                                 .index_type = *index_type,
                                 .value_view = source.sparse.values.bufferView,
                                 .value_offset = source.sparse.values.byteOffset};
  }
  return accessor;
}

/// Translation, rotation (unit quaternion x y z w) and scale as one matrix: T * R * S.
std::array<double, 16> compose(const std::array<double, 3>& t, const std::array<double, 4>& r,
                               const std::array<double, 3>& s) noexcept {
  const auto [x, y, z, w] = r;
  return {s[0] * (1 - 2 * (y * y + z * z)),
          s[0] * 2 * (x * y + z * w),
          s[0] * 2 * (x * z - y * w),
          0,
          s[1] * 2 * (x * y - z * w),
          s[1] * (1 - 2 * (x * x + z * z)),
          s[1] * 2 * (y * z + x * w),
          0,
          s[2] * 2 * (x * z + y * w),
          s[2] * 2 * (y * z - x * w),
          s[2] * (1 - 2 * (x * x + y * y)),
          0,
          t[0],
          t[1],
          t[2],
          1};
}

/// False where `source` has another number of values than `target`; an empty one leaves the default.
template <std::size_t N>
bool copy_numbers(const std::vector<double>& source, std::array<double, N>& target) noexcept {
  if (source.empty()) return true;
  if (source.size() != N) return false;
  for (std::size_t i = 0; i < N; ++i) target[i] = source[i];
  return true;
}

Result<GltfNode> from_tiny(const tinygltf::Node& source) {
  GltfNode node;
  node.mesh = source.mesh;
  node.children = source.children;
  std::array<double, 3> translation{};
  std::array<double, 4> rotation{0, 0, 0, 1};
  std::array<double, 3> scale{1, 1, 1};
  if (!copy_numbers(source.matrix, node.matrix) || !copy_numbers(source.translation, translation) ||
      !copy_numbers(source.rotation, rotation) || !copy_numbers(source.scale, scale))
    return invalid_file("glTF: a node's transform has not the right number of values");
  if (source.matrix.empty()) node.matrix = compose(translation, rotation, scale);
  return node;
}

tinygltf::Accessor to_tiny(const GltfAccessor& source) {
  tinygltf::Accessor accessor;
  accessor.bufferView = source.view;
  accessor.byteOffset = source.offset;
  accessor.count = source.count;
  accessor.componentType = gltf_component_type(source.type);
  accessor.normalized = source.normalized;
  for (const Shape& shape : kShapes)
    if (shape.components == source.components && shape.matrix == source.matrix) accessor.type = shape.type;
  accessor.minValues = source.min;
  accessor.maxValues = source.max;
  return accessor;
}

tinygltf::BufferView to_tiny(const GltfBufferView& source) {
  tinygltf::BufferView view;
  view.buffer = source.buffer;
  view.byteOffset = source.offset;
  view.byteLength = source.length;
  view.byteStride = source.stride;
  view.target = source.indices ? TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER : TINYGLTF_TARGET_ARRAY_BUFFER;
  return view;
}

tinygltf::Mesh to_tiny(const std::vector<GltfPrimitive>& source) {
  tinygltf::Mesh mesh;
  for (const GltfPrimitive& primitive : source) {
    tinygltf::Primitive& target = mesh.primitives.emplace_back();
    target.attributes = primitive.attributes;
    target.indices = primitive.indices;
    target.mode = primitive.mode;
  }
  return mesh;
}

tinygltf::Node to_tiny(const GltfNode& source) {
  tinygltf::Node node;
  node.mesh = source.mesh;
  const auto& m = source.matrix;
  if (m[12] != 0 || m[13] != 0 || m[14] != 0) node.translation = {m[12], m[13], m[14]};
  return node;
}

}  // namespace

Result<GltfDocument> parse_gltf_document(const std::string& json) {
  tinygltf::TinyGLTF loader;
  tinygltf::Model model;
  std::string problem;
  std::string warning;
  if (!loader.LoadASCIIFromString(&model, &problem, &warning, json.c_str(),
                                  static_cast<unsigned>(json.size()), "") ||
      !problem.empty())
    return invalid_file("glTF: a required property is missing, or has a wrong type or value");

  GltfDocument document;
  for (const tinygltf::BufferView& view : model.bufferViews)
    document.views.push_back({.buffer = view.buffer,
                              .offset = view.byteOffset,
                              .length = view.byteLength,
                              .stride = view.byteStride});
  for (const tinygltf::Accessor& source : model.accessors) {
    DELTAMESH_TRY(GltfAccessor accessor, from_tiny(source));
    document.accessors.push_back(std::move(accessor));
  }
  for (const tinygltf::Mesh& mesh : model.meshes) {
    auto& primitives = document.meshes.emplace_back();
    for (const tinygltf::Primitive& primitive : mesh.primitives)
      primitives.push_back(
          {.attributes = primitive.attributes, .indices = primitive.indices, .mode = primitive.mode});
  }
  for (const tinygltf::Node& source : model.nodes) {
    DELTAMESH_TRY(GltfNode node, from_tiny(source));
    document.nodes.push_back(std::move(node));
  }
  for (const tinygltf::Scene& scene : model.scenes) document.scenes.push_back(scene.nodes);
  document.scene = model.defaultScene;
  return document;
}

std::vector<std::byte> serialize_gltf_document(const GltfDocument& document,
                                               std::vector<unsigned char> buffer, bool binary) {
  tinygltf::Model model;
  model.asset.version = "2.0";
  model.asset.generator = "deltamesh";
  if (!buffer.empty()) model.buffers.emplace_back().data = std::move(buffer);
  for (const GltfBufferView& view : document.views) model.bufferViews.push_back(to_tiny(view));
  for (const GltfAccessor& accessor : document.accessors) model.accessors.push_back(to_tiny(accessor));
  for (const auto& mesh : document.meshes) model.meshes.push_back(to_tiny(mesh));
  for (const GltfNode& node : document.nodes) model.nodes.push_back(to_tiny(node));
  for (const auto& roots : document.scenes) model.scenes.emplace_back().nodes = roots;
  model.defaultScene = document.scene;
  std::ostringstream stream;
  tinygltf::TinyGLTF().WriteGltfSceneToStream(&model, stream, false, binary);
  const std::string text = stream.str();
  const auto bytes = std::as_bytes(std::span(text));
  return {bytes.begin(), bytes.end()};
}

}  // namespace deltamesh
