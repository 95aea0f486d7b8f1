// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "io/gltf/scene.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "base/try.h"
#include "io/components.h"
#include "io/gltf/accessor.h"

namespace deltamesh::gltf {
namespace {

constexpr std::size_t kNone = ~std::size_t{0};

/// A number of an element of the array `list` of the asset; kNone where there is no such member. Errors:
/// kInvalidFile.
Result<std::size_t> element_member(const Json& json, const Json& object, const char* key, const char* list) {
  const Error bad{.code = ErrorCode::kInvalidFile, .message = "a node or scene names what does not exist"};
  const Json* value = find(object, key);
  if (!value) return std::size_t{kNone};
  DELTAMESH_TRY(const auto number, to_unsigned(*value, kNoLimit, bad));
  if (number >= array_size(json, list)) return bad;
  return static_cast<std::size_t>(number);
}

/// Numbers of nodes in the array `key`. Errors: kInvalidFile.
Result<std::vector<std::size_t>> node_numbers(const Json& json, const Json& object, const char* key) {
  const Error bad{.code = ErrorCode::kInvalidFile,
                  .message = "a node or scene names a node that does not exist"};
  const Json* list = find(object, key);
  std::vector<std::size_t> numbers;
  if (!list) return numbers;
  if (!list->is_array()) return bad;
  for (const Json& value : *list) {
    DELTAMESH_TRY(const auto number, to_unsigned(value, kNoLimit, bad));
    if (number >= array_size(json, "nodes")) return bad;
    numbers.push_back(static_cast<std::size_t>(number));
  }
  return numbers;
}

/// Roots in order, each once.
Result<std::vector<std::size_t>> find_roots(const Json& json) {
  DELTAMESH_TRY(const std::size_t scene, element_member(json, json, "scene", "scenes"));
  if (scene != kNone) return node_numbers(json, json["scenes"][scene], "nodes");
  std::vector<bool> taken(array_size(json, "nodes"));
  std::vector<std::size_t> roots;
  if (array_size(json, "scenes") == 0) {
    for (const Json& node : json["nodes"]) {
      DELTAMESH_TRY(const auto children, node_numbers(json, node, "children"));
      for (const std::size_t child : children) taken[child] = true;
    }
    for (std::size_t n = 0; n < taken.size(); ++n)
      if (!taken[n]) roots.push_back(n);
    return roots;
  }
  for (const Json& each : json["scenes"]) {  // they may share their roots
    DELTAMESH_TRY(const auto own, node_numbers(json, each, "nodes"));
    for (const std::size_t root : own) {
      if (!taken[root]) roots.push_back(root);
      taken[root] = true;
    }
  }
  return roots;
}

/// Sets the numbers of the array `key`, where it is there. Errors: kInvalidFile.
Result<void> read_numbers(const Json& node, const char* key, std::span<double> numbers) {
  const Error bad{.code = ErrorCode::kInvalidFile,
                  .message = "a node's transform has not the right number of values"};
  const Json* list = find(node, key);
  if (!list) return {};
  if (!list->is_array() || list->size() != numbers.size()) return bad;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (!(*list)[i].is_number()) return bad;
    numbers[i] = (*list)[i].get<double>();
  }
  return {};
}

/// Translation, rotation (unit quaternion x y z w) and scale.
struct Placing {
  std::array<double, 3> translation{0, 0, 0};
  std::array<double, 4> rotation{0, 0, 0, 1};
  std::array<double, 3> scale{1, 1, 1};

  /// T * R * S.
  Transform matrix() const noexcept {
    const auto& [x, y, z, w] = rotation;
    const auto& s = scale;
    const auto& t = translation;
    return {.m = {s[0] * (1 - 2 * (y * y + z * z)), s[0] * 2 * (x * y + z * w), s[0] * 2 * (x * z - y * w), 0,
                  s[1] * 2 * (x * y - z * w), s[1] * (1 - 2 * (x * x + z * z)), s[1] * 2 * (y * z + x * w), 0,
                  s[2] * 2 * (x * z + y * w), s[2] * 2 * (y * z - x * w), s[2] * (1 - 2 * (x * x + y * y)), 0,
                  t[0], t[1], t[2], 1}};
  }
};

Result<Transform> node_transform(const Json& node) {
  Placing placing;
  DELTAMESH_CHECK(read_numbers(node, "translation", placing.translation));
  DELTAMESH_CHECK(read_numbers(node, "rotation", placing.rotation));
  DELTAMESH_CHECK(read_numbers(node, "scale", placing.scale));
  Transform transform = placing.matrix();
  DELTAMESH_CHECK(read_numbers(node, "matrix", transform.m));
  return transform;
}

/// The numbers of row `i`; those there are where the node does not give them.
template <std::size_t kSize>
void read_row(const std::optional<AccessorRows>& rows, std::uint64_t i, std::array<double, kSize>& numbers) {
  for (std::size_t k = 0; rows && k < kSize; ++k)
    numbers[k] = load_normalized(rows->shape().type, rows->shape().normalized,
                                 rows->row(i).data() + k * component_size(rows->shape().type));
}

/// Where the node shows its mesh, relative to itself: once, unless EXT_mesh_gpu_instancing says otherwise.
Result<std::vector<Transform>> instances_of(const Document& document, const Json& node) {
  const Error bad{.code = ErrorCode::kInvalidFile, .message = "the instances of a node are malformed"};
  const Json* extensions = find(node, "extensions");
  const Json* instancing = extensions ? find(*extensions, "EXT_mesh_gpu_instancing") : nullptr;
  const Json* attributes = instancing ? find(*instancing, "attributes") : nullptr;
  if (!attributes) return std::vector<Transform>(1);
  std::array<std::optional<AccessorRows>, 3> columns;
  std::optional<std::uint64_t> count;
  for (std::size_t c = 0; c < 3; ++c) {
    constexpr std::array<const char*, 3> kNames{"TRANSLATION", "ROTATION", "SCALE"};
    DELTAMESH_TRY(const auto accessor, element_member(document.json, *attributes, kNames[c], "accessors"));
    if (accessor == kNone) continue;
    DELTAMESH_TRY(columns[c], read_accessor(document, accessor, 0));
    if (!columns[c] || columns[c]->shape().components != (c == 1 ? 4 : 3)) return bad;
    if (count.value_or(columns[c]->shape().count) != columns[c]->shape().count) return bad;
    count = columns[c]->shape().count;
  }
  std::vector<Transform> instances;
  for (std::uint64_t i = 0; i < count.value_or(0); ++i) {
    Placing placing;
    read_row(columns[0], i, placing.translation);
    read_row(columns[1], i, placing.rotation);
    read_row(columns[2], i, placing.scale);
    instances.push_back(placing.matrix());
  }
  return instances;
}

}  // namespace

// For a linear part with columns a, b, c the inverse transpose is (b x c, c x a, a x b) / det.
Vec3 Transform::normal(const Vec3& n) const noexcept {
  const Vec3 a = column(0);
  const Vec3 b = column(1);
  const Vec3 c = column(2);
  const Vec3 turned = n[0] * cross(b, c) + n[1] * cross(c, a) + n[2] * cross(a, b);
  const double size = length(turned);
  if (!(size > 0) || !std::isfinite(size)) return n;
  return (determinant() < 0 ? -1 / size : 1 / size) * turned;
}

Transform Transform::operator*(const Transform& b) const noexcept {
  Transform product;
  for (std::size_t c = 0; c < 4; ++c) {
    const Vec3 moved = c < 3 ? direction(b.column(c)) : point(b.column(c));
    std::copy(moved.begin(), moved.end(), product.m.begin() + static_cast<std::ptrdiff_t>(4 * c));
  }
  return product;
}

Result<std::vector<Placement>> place_meshes(const Document& document) {
  constexpr std::uint64_t kFreePlaces = 4096;
  const Json& json = document.json;
  std::vector<Placement> placements;
  if (array_size(json, "nodes") == 0 && array_size(json, "scenes") == 0) {
    for (std::size_t m = 0; m < array_size(json, "meshes"); ++m) placements.push_back({.mesh = m});
    return placements;
  }
  DELTAMESH_TRY(const auto roots, find_roots(json));
  // An explicit stack: depth is the file's choice.
  std::vector<std::pair<std::size_t, Transform>> stack;
  for (auto root = roots.rbegin(); root != roots.rend(); ++root) stack.emplace_back(*root, Transform{});
  std::vector<bool> visited(array_size(json, "nodes"));
  while (!stack.empty()) {
    const auto [number, parent] = stack.back();
    stack.pop_back();
    if (visited[number]) return element_error("a node with two parents, or inside itself", number);
    visited[number] = true;
    const Json& node = json["nodes"][number];
    DELTAMESH_TRY(const Transform own, node_transform(node));
    const Transform transform = parent * own;
    DELTAMESH_TRY(const std::size_t mesh, element_member(json, node, "mesh", "meshes"));
    if (mesh != kNone) {
      DELTAMESH_TRY(const auto instances, instances_of(document, node));
      if (placements.size() + instances.size() > kFreePlaces + document.input_bytes)
        return element_error("a node repeats its mesh more often than the size of the file suggests", number);
      for (const Transform& instance : instances)
        placements.push_back({.mesh = mesh,
                              .node = number,
                              .transform = node.contains("skin") ? Transform{} : transform * instance});
    }
    DELTAMESH_TRY(const auto children, node_numbers(json, node, "children"));
    for (auto child = children.rbegin(); child != children.rend(); ++child)
      stack.emplace_back(*child, transform);
  }
  return placements;
}

std::uint64_t hidden_meshes(const Json& json, const std::vector<Placement>& placements) {
  std::vector<bool> shown(array_size(json, "nodes"));
  std::vector<bool> named(array_size(json, "meshes"));
  for (const Placement& placement : placements) {
    if (placement.node) shown[*placement.node] = true;
    named[placement.mesh] = true;
  }
  std::uint64_t hidden = 0;
  for (std::size_t n = 0; n < shown.size(); ++n) {
    const auto mesh = unsigned_member(json["nodes"][n], "mesh", kNoLimit, kNoLimit, {});
    if (shown[n] || !mesh || *mesh >= named.size()) continue;
    named[static_cast<std::size_t>(*mesh)] = true;
    ++hidden;
  }
  return hidden + static_cast<std::uint64_t>(std::count(named.begin(), named.end(), false));
}

}  // namespace deltamesh::gltf
