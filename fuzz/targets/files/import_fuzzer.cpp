// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Any bytes into the importer of DELTAMESH_FORMAT, a FileFormat. What it promises must hold of the mesh,
// which is then written in its own format and read again.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>

#include "deltamesh/io.h"
#include "goal.h"

namespace {

using namespace deltamesh;

fuzz::Goal imported_and_back("a file");

void require(bool condition) {
  if (!condition) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr FileFormat kFormat = FileFormat::DELTAMESH_FORMAT;
  const auto imported = read_mesh(std::as_bytes(std::span(data, size)), kFormat);
  if (!imported) {
    require(imported.error().code == ErrorCode::kInvalidFile ||
            imported.error().code == ErrorCode::kLimitExceeded);
    return 0;
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
  const auto written = write_mesh(mesh, kFormat);
  if (!written) {  // coordinates that are not finite are the one thing a format may refuse
    require(written.error().code == ErrorCode::kNotFinite);
    return 0;
  }
  const auto again = read_mesh(*written, kFormat);
  require(again.has_value());
  require(again->mesh.triangle_count() == mesh.triangle_count());
  imported_and_back.reach();
  return 0;
}
