// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What the names of vertex attributes mean: kinds of stream attributes, values where a primitive has none,
// and the types that core glTF allows.
#pragma once

#include <cstddef>
#include <string>
#include <tuple>
#include <vector>

#include "deltamesh/mesh.h"
#include "io/gltf/accessor.h"

namespace deltamesh::gltf {

/// The vertex attribute itself, and not its displacement by a morph target.
inline constexpr int kBase = -1;

/// An attribute of vertices, or what morph target number `target` adds to it.
struct Semantic {
  std::string name;
  int target = kBase;
  bool operator==(const Semantic&) const = default;
  bool operator<(const Semantic& other) const noexcept {
    return std::tie(name, target) < std::tie(other.name, other.target);
  }
};

/// Morph displacements, and shapes that the kind does not have, are generic.
AttributeKind kind_of(const Semantic& semantic, const AccessorShape& shape) noexcept;

/// The attribute's name in the stream: only generic attributes have one, by which they get their bounds.
/// Displacements in floats are called "d" and their semantic, so that all targets share a bound.
std::string stream_name(const Semantic& semantic, const AccessorShape& shape);

/// Whether the attribute cannot move a vertex: normals, tangents, texture coordinates and colours of the
/// base.
bool is_look(const Semantic& semantic) noexcept;

/// One row that stands in the stream for a vertex whose primitive does not have the attribute.
std::vector<std::byte> filler_row(AttributeKind kind, const AccessorShape& shape);

/// Whether glTF allows an accessor of this shape for the attribute without KHR_mesh_quantization.
bool is_core_shape(const Semantic& semantic, const AccessorShape& shape) noexcept;

/// Whether positions can be made of it: three floats, or the integers of KHR_mesh_quantization.
bool is_position_shape(const AccessorShape& shape) noexcept;

}  // namespace deltamesh::gltf
