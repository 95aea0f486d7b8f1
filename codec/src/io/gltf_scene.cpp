// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "io/gltf_scene.h"

#include <cmath>
#include <cstdint>
#include <utility>

#include "base/try.h"

namespace deltamesh {
namespace {

using gltf::element_error;
using gltf::Json;

/// The whole numbers of the array `key`, each below `below`; none where it is absent.
Result<std::vector<std::size_t>> references(const Json& object, const char* key, std::size_t below,
                                            const Error& otherwise) {
  std::vector<std::size_t> numbers;
  const Json* const array = gltf::find(object, key);
  if (array == nullptr) return numbers;
  if (!array->is_array()) return otherwise;
  for (const Json& entry : *array) {
    DELTAMESH_TRY(const auto number, gltf::to_unsigned(entry, ~std::uint64_t{0}, otherwise));
    if (number >= below) return otherwise;
    numbers.push_back(number);
  }
  return numbers;
}

Result<std::vector<std::size_t>> children_of(const Json& nodes, std::size_t node) {
  return references(nodes[node], "children", nodes.size(),
                    element_error("a node's child does not exist", node));
}

/// Roots in order, each once.
Result<std::vector<std::size_t>> find_roots(const Json& asset, const Json& nodes) {
  const std::size_t scenes = gltf::array_size(asset, "scenes");
  const auto roots_of = [&](std::size_t scene) {
    return references(asset["scenes"][scene], "nodes", nodes.size(),
                      element_error("a scene names a node that does not exist", scene));
  };
  if (const Json* const chosen = gltf::find(asset, "scene")) {
    const Error bad{.code = ErrorCode::kInvalidFile, .message = "the default scene does not exist"};
    DELTAMESH_TRY(const auto scene, gltf::to_unsigned(*chosen, ~std::uint64_t{0}, bad));
    if (scene >= scenes) return bad;
    return roots_of(scene);
  }
  std::vector<std::size_t> roots;
  std::vector<bool> taken(nodes.size());
  if (scenes == 0) {
    for (std::size_t n = 0; n < nodes.size(); ++n) {
      DELTAMESH_TRY(const auto children, children_of(nodes, n));
      for (const std::size_t child : children) taken[child] = true;
    }
    for (std::size_t n = 0; n < nodes.size(); ++n)
      if (!taken[n]) roots.push_back(n);
    return roots;
  }
  // Scenes may share their roots.
  for (std::size_t scene = 0; scene < scenes; ++scene) {
    DELTAMESH_TRY(const auto own, roots_of(scene));
    for (const std::size_t root : own) {
      if (!taken[root]) roots.push_back(root);
      taken[root] = true;
    }
  }
  return roots;
}

/// Reads the numbers of the array `key`, where it is there, into `target`.
template <std::size_t N>
Result<void> read_numbers(const Json& node, const char* key, std::array<double, N>& target) {
  constexpr Error kBad{.code = ErrorCode::kInvalidFile,
                       .message = "a node's transform is not made of the right number of numbers"};
  const Json* const array = gltf::find(node, key);
  if (array == nullptr) return {};
  if (!array->is_array() || array->size() != N) return kBad;
  for (std::size_t i = 0; i < N; ++i) {
    if (!(*array)[i].is_number()) return kBad;
    target[i] = (*array)[i].template get<double>();
  }
  return {};
}

/// The node's own transform: its matrix, else translation * rotation (a unit quaternion x y z w) * scale.
Result<GltfTransform> transform_of(const Json& node) {
  GltfTransform transform;
  std::array<double, 3> t{};
  std::array<double, 4> r{0, 0, 0, 1};
  std::array<double, 3> s{1, 1, 1};
  DELTAMESH_CHECK(read_numbers(node, "matrix", transform.m));
  DELTAMESH_CHECK(read_numbers(node, "translation", t));
  DELTAMESH_CHECK(read_numbers(node, "rotation", r));
  DELTAMESH_CHECK(read_numbers(node, "scale", s));
  if (node.contains("matrix")) return transform;
  const auto [x, y, z, w] = r;
  const std::array<Vec3, 3> columns{{{1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)},
                                     {2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)},
                                     {2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)}}};
  for (std::size_t c = 0; c < 3; ++c) transform.set_column(c, s[c] * columns[c]);
  transform.set_column(3, t);
  return transform;
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
  for (std::size_t c = 0; c < 4; ++c)
    product.set_column(c, c < 3 ? a.direction(b.column(c)) : a.point(b.column(c)));
  return product;
}

Result<std::vector<GltfPlacement>> place_meshes(const Json& asset) {
  std::vector<GltfPlacement> placements;
  const std::size_t meshes = gltf::array_size(asset, "meshes");
  const Json* const listed = gltf::find(asset, "nodes");
  const Json nodes = listed != nullptr ? *listed : Json::array();
  if (nodes.empty() && gltf::array_size(asset, "scenes") == 0) {
    for (std::size_t m = 0; m < meshes; ++m) placements.push_back({.mesh = m, .transform = {}});
    return placements;
  }
  DELTAMESH_TRY(const std::vector<std::size_t> roots, find_roots(asset, nodes));
  // An explicit stack: depth is the file's choice.
  std::vector<std::pair<std::size_t, GltfTransform>> stack;
  for (auto root = roots.rbegin(); root != roots.rend(); ++root) stack.emplace_back(*root, GltfTransform{});
  std::vector<bool> visited(nodes.size());
  while (!stack.empty()) {
    const auto [n, parent] = stack.back();
    stack.pop_back();
    if (visited[n]) return element_error("a node with two parents, or inside itself", n);
    visited[n] = true;
    DELTAMESH_TRY(const GltfTransform own, transform_of(nodes[n]));
    const GltfTransform transform = parent * own;
    if (const Json* const named = gltf::find(nodes[n], "mesh")) {
      const Error bad = element_error("a node's mesh does not exist", n);
      DELTAMESH_TRY(const auto mesh, gltf::to_unsigned(*named, ~std::uint64_t{0}, bad));
      if (mesh >= meshes) return bad;
      placements.push_back({.mesh = mesh, .transform = transform});
    }
    DELTAMESH_TRY(const auto children, children_of(nodes, n));
    for (auto child = children.rbegin(); child != children.rend(); ++child)
      stack.emplace_back(*child, transform);
  }
  return placements;
}

}  // namespace deltamesh
