// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Takes parts of a mesh out of it.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>

#include "deltamesh/mesh.h"

namespace deltamesh::bench {

/// The bits of a vertex' position, and those of its attributes.
std::string position_bits(const Mesh& mesh, std::uint32_t vertex);
std::string vertex_bits(const Mesh& mesh, std::uint32_t vertex);

/// A mesh of the corners that it is given, vertices in the order of first appearance.
class VertexPicker {
 public:
  /// `mesh` outlives the picker. `welds`: vertices with equal bits are one.
  VertexPicker(const Mesh& mesh, bool welds);

  void add_corner(std::uint32_t vertex);

  Mesh take() { return std::move(picked_); }

 private:
  const Mesh* mesh_;
  bool welds_;
  Mesh picked_;
  std::unordered_map<std::uint32_t, std::uint32_t> numbers_;
  std::unordered_map<std::string, std::uint32_t> numbers_of_bits_;
};

}  // namespace deltamesh::bench
