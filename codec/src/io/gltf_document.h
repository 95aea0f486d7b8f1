// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The parts of a glTF asset that make up its geometry, as plain structs: what tinygltf is asked for when an
// asset is read.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "deltamesh/mesh.h"
#include "deltamesh/result.h"

namespace deltamesh {

/// glTF's numbers for Primitive::mode.
enum class GltfMode : int { kTriangles = 4, kTriangleStrip = 5, kTriangleFan = 6 };

struct GltfBufferView {
  int buffer = 0;
  std::uint64_t offset = 0;
  std::uint64_t length = 0;
  std::uint64_t stride = 0;  ///< 0: tightly packed
};

struct GltfSparse {
  int count = 0;
  int index_view = 0;
  int index_offset = 0;
  ComponentType index_type = ComponentType::kU32;
  int value_view = 0;
  int value_offset = 0;
};

struct GltfAccessor {
  static constexpr int kNone = -1;
  int view = kNone;  ///< kNone: all values are 0
  std::uint64_t offset = 0;
  std::uint64_t count = 0;
  ComponentType type = ComponentType::kF32;
  std::uint8_t components = 1;  ///< 1 to 4; 4, 9, 16 for matrices
  bool matrix = false;
  bool normalized = false;
  std::optional<GltfSparse> sparse;
};

struct GltfPrimitive {
  std::map<std::string, int> attributes;  ///< semantic -> accessor
  int indices = GltfAccessor::kNone;
  int mode = static_cast<int>(GltfMode::kTriangles);
};

struct GltfNode {
  int mesh = GltfAccessor::kNone;
  std::vector<int> children;
  std::array<double, 16> matrix{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};  ///< column-major
};

struct GltfDocument {
  std::vector<GltfBufferView> views;
  std::vector<GltfAccessor> accessors;
  std::vector<std::vector<GltfPrimitive>> meshes;
  std::vector<GltfNode> nodes;
  std::vector<std::vector<int>> scenes;  ///< root nodes
  int scene = GltfAccessor::kNone;       ///< the default scene
};

/// From JSON text that filter_gltf_json() has passed. Indices are not checked against the arrays. Errors:
/// kInvalidFile.
Result<GltfDocument> parse_gltf_document(const std::string& json);

/// glTF's number for a component type; 0 where it has none.
int gltf_component_type(ComponentType type) noexcept;

}  // namespace deltamesh
