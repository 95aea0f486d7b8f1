// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "deltamesh/map/join.h"

#include <algorithm>
#include <compare>
#include <cstddef>
#include <cstring>
#include <tuple>
#include <utility>

#include "base/guard.h"
#include "base/try.h"

namespace deltamesh {
namespace {

Error invalid_part(const char* message, std::uint64_t part) noexcept {
  return {.code = ErrorCode::kInvalidArgument,
          .message = message,
          .where_kind = WhereKind::kElement,
          .where = part};
}

bool has_same_shape(const Attribute& a, const Attribute& b) noexcept {
  return a.kind == b.kind && a.type == b.type && a.components == b.components &&
         a.normalized == b.normalized && a.name == b.name && a.linear == b.linear;
}

Result<void> check_part(const MapPart& part, const MapPart& first, std::uint64_t number) {
  const Mesh& mesh = part.mesh;
  if (mesh.origin != first.mesh.origin) return invalid_part("parts of different origins", number);
  if (mesh.attributes.size() != first.mesh.attributes.size())
    return invalid_part("parts of different attributes", number);
  for (std::size_t i = 0; i < mesh.attributes.size(); ++i) {
    const Attribute& attribute = mesh.attributes[i];
    if (!has_same_shape(attribute, first.mesh.attributes[i]))
      return invalid_part("parts of different attributes", number);
    if (attribute.values.size() !=
        mesh.vertex_count() * attribute.components * component_size(attribute.type))
      return invalid_part("attribute values that are not as many as vertices", number);
  }
  if (std::ranges::any_of(mesh.triangles, [&](std::uint32_t v) { return v >= mesh.vertex_count(); }) ||
      std::ranges::any_of(part.border,
                          [&](const BorderVertex& b) { return b.vertex >= mesh.vertex_count(); }))
    return invalid_part("a vertex that is not there", number);
  return {};
}

/// A border vertex of one of the parts.
struct BorderPlace {
  LatticePoint point{};
  std::uint32_t twin = 0;
  std::uint32_t part = 0;
  std::uint32_t vertex = 0;
};

std::span<const std::byte> value_of(const Attribute& attribute, std::uint32_t vertex) noexcept {
  const std::size_t size = attribute.components * component_size(attribute.type);
  return std::span(attribute.values).subspan(size * vertex, size);
}

class Joiner {
 public:
  explicit Joiner(std::span<const MapPart> parts) : parts_(parts) {}

  Mesh run() {
    find_first_vertices();
    const Mesh& first = parts_.front().mesh;
    joined_.origin = first.origin;
    for (Attribute attribute : first.attributes) {
      attribute.values.clear();
      joined_.attributes.push_back(std::move(attribute));
    }
    const bool has_groups =
        std::ranges::any_of(parts_, [](const MapPart& part) { return !part.mesh.face_groups.empty(); });
    for (std::size_t p = 0; p < parts_.size(); ++p) {
      add_vertices(p);
      const Mesh& mesh = parts_[p].mesh;
      for (const std::uint32_t v : mesh.triangles) joined_.triangles.push_back(numbers_[p][v]);
      if (!has_groups) continue;
      joined_.face_groups.insert(joined_.face_groups.end(), mesh.face_groups.begin(), mesh.face_groups.end());
      joined_.face_groups.resize(joined_.triangle_count(), 0);
    }
    return std::move(joined_);
  }

 private:
  struct First {
    std::uint32_t part;
    std::uint32_t vertex;
  };

  /// For each border vertex the one that it becomes one with.
  void find_first_vertices() {
    std::vector<BorderPlace> places;
    for (std::size_t p = 0; p < parts_.size(); ++p) {
      firsts_.emplace_back(parts_[p].mesh.vertex_count());
      for (std::uint32_t v = 0; v < firsts_[p].size(); ++v)
        firsts_[p][v] = {static_cast<std::uint32_t>(p), v};
      for (const BorderVertex& b : parts_[p].border)
        places.push_back({b.point, b.twin, static_cast<std::uint32_t>(p), b.vertex});
    }
    std::ranges::sort(places, [&](const BorderPlace& a, const BorderPlace& b) {
      const auto order = compare(a, b);
      return order != 0 ? order < 0 : std::tie(a.part, a.vertex) < std::tie(b.part, b.vertex);
    });
    const BorderPlace* first = places.data();
    for (const BorderPlace& place : places) {
      if (compare(*first, place) != 0) first = &place;
      firsts_[place.part][place.vertex] = {first->part, first->vertex};
    }
  }

  /// Equal: one vertex of the joined mesh.
  std::strong_ordering compare(const BorderPlace& a, const BorderPlace& b) const {
    if (const auto order = std::tie(a.point, a.twin) <=> std::tie(b.point, b.twin); order != 0) return order;
    const auto& of_a = parts_[a.part].mesh.attributes;
    const auto& of_b = parts_[b.part].mesh.attributes;
    for (std::size_t i = 0; i < of_a.size(); ++i) {
      const auto value = value_of(of_a[i], a.vertex);
      const int order = std::memcmp(value.data(), value_of(of_b[i], b.vertex).data(), value.size());
      if (order != 0) return order <=> 0;
    }
    return std::strong_ordering::equal;
  }

  void add_vertices(std::size_t p) {
    const Mesh& mesh = parts_[p].mesh;
    numbers_.emplace_back(mesh.vertex_count());
    for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) {
      const First first = firsts_[p][v];
      if (first.part != p || first.vertex != v) {
        numbers_[p][v] = numbers_[first.part][first.vertex];
        continue;
      }
      numbers_[p][v] = static_cast<std::uint32_t>(joined_.vertex_count());
      const float* x = mesh.positions.data() + 3 * std::size_t{v};
      joined_.positions.insert(joined_.positions.end(), x, x + 3);
      for (std::size_t i = 0; i < mesh.attributes.size(); ++i) {
        const auto value = value_of(mesh.attributes[i], v);
        joined_.attributes[i].values.insert(joined_.attributes[i].values.end(), value.begin(), value.end());
      }
    }
  }

  std::span<const MapPart> parts_;
  std::vector<std::vector<First>> firsts_;           ///< by part and vertex
  std::vector<std::vector<std::uint32_t>> numbers_;  ///< likewise, of the joined mesh
  Mesh joined_;
};

}  // namespace

Result<Mesh> join(std::span<const MapPart> parts) noexcept {
  return guarded([&]() -> Result<Mesh> {
    if (parts.empty()) return Mesh();
    for (std::size_t p = 0; p < parts.size(); ++p) DELTAMESH_CHECK(check_part(parts[p], parts.front(), p));
    return Joiner(parts).run();
  });
}

}  // namespace deltamesh
