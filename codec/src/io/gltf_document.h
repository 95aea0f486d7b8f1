// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// A glTF asset as tinygltf parses it, with the types and shapes of its accessors in our terms.
#pragma once

#include <tiny_gltf.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "deltamesh/mesh.h"
#include "deltamesh/result.h"

namespace deltamesh {

inline constexpr int kGltfNone = -1;  ///< an index that is not given

struct GltfAccessor {
  int view = kGltfNone;  ///< kGltfNone: all values are 0
  std::uint64_t offset = 0;
  std::uint64_t count = 0;
  ComponentType type = ComponentType::kF32;
  std::uint8_t components = 1;  ///< 1 to 4; 4, 9, 16 for matrices
  bool matrix = false;
  bool normalized = false;
  decltype(tinygltf::Accessor::sparse) sparse;
  ComponentType index_type = ComponentType::kU32;  ///< of its indices
};

struct GltfDocument {
  tinygltf::Model model;                ///< every node has a matrix, column-major
  std::vector<GltfAccessor> accessors;  ///< those of the model
};

/// From JSON text that filtered_gltf() has passed. Indices are not checked against the arrays. Errors:
/// kInvalidFile.
Result<GltfDocument> parse_gltf_document(const std::string& json);

/// glTF's number for a component type, which is neither kI32 nor kF64.
constexpr int gltf_component_type(ComponentType type) noexcept {
  return TINYGLTF_COMPONENT_TYPE_BYTE + static_cast<int>(type);
}

}  // namespace deltamesh
