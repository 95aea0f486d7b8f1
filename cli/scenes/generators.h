// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What every generator fills in.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "deltamesh/mesh.h"
#include "point.h"

namespace deltamesh::scenes {

/// Appends and returns the new vertex's index.
inline std::uint32_t add_vertex(Mesh& mesh, const Point& p) {
  for (const double x : {p.x, p.y, p.z}) mesh.positions.push_back(static_cast<float>(x));
  return static_cast<std::uint32_t>(mesh.vertex_count() - 1);
}

inline void add_triangle(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  mesh.triangles.insert(mesh.triangles.end(), {a, b, c});
}

/// a, b, c, d around the quad; the diagonal is a-c.
inline void add_quad(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
  add_triangle(mesh, a, b, c);
  add_triangle(mesh, a, c, d);
}

template <class T>
void add_attribute(Mesh& mesh, AttributeKind kind, ComponentType type, std::uint8_t components,
                   std::string_view name, std::span<const T> values) {
  Attribute attribute;
  attribute.kind = kind;
  attribute.type = type;
  attribute.components = components;
  attribute.normalized = kind == AttributeKind::kColor;
  attribute.name = name;
  const auto bytes = std::as_bytes(values);
  attribute.values.assign(bytes.begin(), bytes.end());
  mesh.attributes.push_back(std::move(attribute));
}

/// One generator per scene; `target`: vertices asked for.
Mesh make_rooms(std::uint64_t target, std::uint64_t seed);
Mesh make_terrain(std::uint64_t target, std::uint64_t seed);
Mesh make_sphere(std::uint64_t target, std::uint64_t seed);
Mesh make_torus(std::uint64_t target, std::uint64_t seed);
Mesh make_cad(std::uint64_t target, std::uint64_t seed);
Mesh make_fragments(std::uint64_t target, std::uint64_t seed);

}  // namespace deltamesh::scenes
