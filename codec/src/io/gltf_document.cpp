// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "io/gltf_document.h"

#include <tiny_gltf.h>

#include <utility>

#include "base/try.h"
#include "io/io_error.h"

namespace deltamesh {
namespace {

constexpr std::array<std::pair<ComponentType, int>, 6> kComponentTypes{
    {{ComponentType::kI8, TINYGLTF_COMPONENT_TYPE_BYTE},
     {ComponentType::kU8, TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE},
     {ComponentType::kI16, TINYGLTF_COMPONENT_TYPE_SHORT},
     {ComponentType::kU16, TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT},
     {ComponentType::kU32, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT},
     {ComponentType::kF32, TINYGLTF_COMPONENT_TYPE_FLOAT}}};

std::optional<ComponentType> component_type(int gltf) noexcept {
  for (const auto& [type, number] : kComponentTypes)
    if (number == gltf) return type;
  return std::nullopt;
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

}  // namespace

int gltf_component_type(ComponentType type) noexcept {
  for (const auto& [known, number] : kComponentTypes)
    if (known == type) return number;
  return 0;
}

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

}  // namespace deltamesh
