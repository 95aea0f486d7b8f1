// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// What all importer targets do: read the bytes, check what the importer promises, write the mesh in its own
// format.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <span>

#include "deltamesh/io.h"
#include "goal.h"

namespace deltamesh {

inline fuzz::Goal imported_and_back("a file");

/// Stops the program where a promise of read_mesh() or write_mesh() is broken.
inline void fuzz_import(const std::uint8_t* data, std::size_t size, FileFormat format) {
  const auto require = [](bool condition) {
    if (!condition) std::abort();
  };
  const auto imported = read_mesh({reinterpret_cast<const std::byte*>(data), size}, format);
  if (!imported) {
    require(imported.error().code == ErrorCode::kInvalidFile ||
            imported.error().code == ErrorCode::kLimitExceeded);
    return;
  }
  const Mesh& mesh = imported->mesh;
  require(mesh.positions.size() % 3 == 0 && mesh.triangles.size() % 3 == 0);
  for (const std::uint32_t index : mesh.triangles) require(index < mesh.vertex_count());
  require(mesh.face_groups.empty() || mesh.face_groups.size() == mesh.triangle_count());
  for (const Attribute& attribute : mesh.attributes) {
    require(attribute.components >= 1 && attribute.components <= 16);
    require(!attribute.name.empty() && attribute.name.size() <= 255);
    require(attribute.values.size() ==
            mesh.vertex_count() * attribute.components * component_size(attribute.type));
  }
  const auto written = write_mesh(mesh, format);
  // Coordinates that are not finite are the one thing a format may refuse.
  if (!written) return require(written.error().code == ErrorCode::kNotFinite);
  const auto again = read_mesh(*written, format);
  require(again.has_value());
  require(again->mesh.triangle_count() == mesh.triangle_count());
  imported_and_back.reach();
}

}  // namespace deltamesh
