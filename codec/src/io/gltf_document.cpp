// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "io/gltf_document.h"

#include <initializer_list>
#include <optional>

#include "base/try.h"
#include "io/io_error.h"

namespace deltamesh {
namespace {

std::optional<ComponentType> component_type(int gltf) noexcept {
  using enum ComponentType;
  for (const ComponentType type : {kI8, kU8, kI16, kU16, kU32, kF32})
    if (gltf_component_type(type) == gltf) return type;
  return std::nullopt;
}

Result<GltfAccessor> from_tiny(const tinygltf::Accessor& source) {
  const auto type = component_type(source.componentType);
  if (!type) return invalid_file("glTF: an accessor of unknown component type");
  const auto index_type = component_type(source.sparse.indices.componentType);
  if (source.sparse.isSparse && !index_type)
    return invalid_file("glTF: a sparse accessor with indices of unknown component type");
  const int components = tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(source.type));
  return GltfAccessor{.view = source.bufferView,
                      .offset = source.byteOffset,
                      .count = source.count,
                      .type = *type,
                      .components = static_cast<std::uint8_t>(components),
                      .matrix = source.type >= TINYGLTF_TYPE_MAT2 && source.type <= TINYGLTF_TYPE_MAT4,
                      .normalized = source.normalized,
                      .sparse = source.sparse,
                      .index_type = index_type.value_or(ComponentType::kU32)};
}

/// Translation, rotation (unit quaternion x y z w) and scale as one matrix: T * R * S.
std::vector<double> compose(const std::vector<double>& t, const std::vector<double>& r,
                            const std::vector<double>& s) {
  const double x = r[0];
  const double y = r[1];
  const double z = r[2];
  const double w = r[3];
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

/// Sets the matrix of a node that is placed otherwise.
Result<void> set_matrix(tinygltf::Node& node) {
  const auto complete = [](std::vector<double>& numbers, std::initializer_list<double> otherwise) {
    if (numbers.empty()) numbers = otherwise;
    return numbers.size() == otherwise.size();
  };
  const bool is_complete = complete(node.translation, {0, 0, 0}) && complete(node.rotation, {0, 0, 0, 1}) &&
                           complete(node.scale, {1, 1, 1});
  if (is_complete && node.matrix.empty()) node.matrix = compose(node.translation, node.rotation, node.scale);
  if (!is_complete || node.matrix.size() != 16)
    return invalid_file("glTF: a node's transform has not the right number of values");
  return {};
}

}  // namespace

Result<GltfDocument> parse_gltf_document(const std::string& json) {
  GltfDocument document;
  std::string problem;
  std::string warning;
  if (!tinygltf::TinyGLTF().LoadASCIIFromString(&document.model, &problem, &warning, json.c_str(),
                                                static_cast<unsigned>(json.size()), "") ||
      !problem.empty())
    return invalid_file("glTF: a required property is missing, or has a wrong type or value");
  for (const tinygltf::Accessor& source : document.model.accessors) {
    DELTAMESH_TRY(const GltfAccessor accessor, from_tiny(source));
    document.accessors.push_back(accessor);
  }
  for (tinygltf::Node& node : document.model.nodes) DELTAMESH_CHECK(set_matrix(node));
  return document;
}

}  // namespace deltamesh
