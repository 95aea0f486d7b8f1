// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "io/gltf_scene.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/try.h"
#include "io/io_error.h"

namespace deltamesh {
namespace {

bool is_index(int index, std::size_t size) noexcept {
  return index >= 0 && static_cast<std::size_t>(index) < size;
}

/// Roots in order, each once.
Result<std::vector<int>> find_roots(const tinygltf::Model& model) {
  if (model.defaultScene != kGltfNone) {
    if (!is_index(model.defaultScene, model.scenes.size()))
      return invalid_file("glTF: the default scene does not exist");
    return model.scenes[static_cast<std::size_t>(model.defaultScene)].nodes;
  }
  std::vector<int> roots;
  if (model.scenes.empty()) {
    std::vector<bool> is_child(model.nodes.size());
    for (const tinygltf::Node& node : model.nodes)
      for (const int child : node.children)
        if (is_index(child, is_child.size())) is_child[static_cast<std::size_t>(child)] = true;
    for (std::size_t n = 0; n < is_child.size(); ++n)
      if (!is_child[n]) roots.push_back(static_cast<int>(n));
    return roots;
  }
  // Scenes may share their roots.
  std::vector<bool> taken(model.nodes.size());
  for (const tinygltf::Scene& scene : model.scenes) {
    for (const int root : scene.nodes) {
      if (!is_index(root, taken.size()))
        return invalid_file("glTF: a scene names a node that does not exist");
      if (!taken[static_cast<std::size_t>(root)]) roots.push_back(root);
      taken[static_cast<std::size_t>(root)] = true;
    }
  }
  return roots;
}

}  // namespace

// For a linear part with columns a, b, c the inverse transpose is (b x c, c x a, a x b) / det.
Vec3 GltfTransform::normal(const Vec3& n) const noexcept {
  const Vec3 a = column(0);
  const Vec3 b = column(1);
  const Vec3 c = column(2);
  const Vec3 turned = n[0] * cross(b, c) + n[1] * cross(c, a) + n[2] * cross(a, b);
  const double size = length(turned);
  if (!(size > 0) || !std::isfinite(size)) return n;
  return (determinant() < 0 ? -1 / size : 1 / size) * turned;
}

GltfTransform operator*(const GltfTransform& a, const GltfTransform& b) noexcept {
  GltfTransform product;
  for (std::size_t c = 0; c < 4; ++c) {
    const Vec3 column = c < 3 ? a.direction(b.column(c)) : a.point(b.column(c));
    std::copy(column.begin(), column.end(), product.m.begin() + static_cast<std::ptrdiff_t>(4 * c));
  }
  return product;
}

Result<std::vector<GltfPlacement>> place_meshes(const tinygltf::Model& model) {
  std::vector<GltfPlacement> placements;
  if (model.nodes.empty() && model.scenes.empty()) {
    for (std::size_t m = 0; m < model.meshes.size(); ++m) placements.push_back({.mesh = m, .transform = {}});
    return placements;
  }
  DELTAMESH_TRY(const std::vector<int> roots, find_roots(model));
  // An explicit stack: depth is the file's choice.
  std::vector<std::pair<int, GltfTransform>> stack;
  for (auto root = roots.rbegin(); root != roots.rend(); ++root) stack.emplace_back(*root, GltfTransform{});
  std::vector<bool> visited(model.nodes.size());
  while (!stack.empty()) {
    const auto [index, parent] = stack.back();
    stack.pop_back();
    if (!is_index(index, visited.size())) return invalid_file("glTF: a node that does not exist");
    if (visited[static_cast<std::size_t>(index)])
      return invalid_file("glTF: a node with two parents, or inside itself");
    visited[static_cast<std::size_t>(index)] = true;
    const tinygltf::Node& node = model.nodes[static_cast<std::size_t>(index)];
    GltfTransform own;
    std::copy(node.matrix.begin(), node.matrix.end(), own.m.begin());
    const GltfTransform transform = parent * own;
    if (node.mesh != kGltfNone) {
      if (!is_index(node.mesh, model.meshes.size())) return invalid_file("glTF: a mesh that does not exist");
      placements.push_back({.mesh = static_cast<std::size_t>(node.mesh), .transform = transform});
    }
    for (auto child = node.children.rbegin(); child != node.children.rend(); ++child)
      stack.emplace_back(*child, transform);
  }
  return placements;
}

}  // namespace deltamesh
