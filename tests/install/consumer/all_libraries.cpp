// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Calls into every installed library, so that what each needs at link time is proved to be exported.
#include <deltamesh/encode.h>
#include <deltamesh/gltf.h>
#include <deltamesh/io.h>

int main() {
  deltamesh::Mesh mesh;
  mesh.positions = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  mesh.triangles = {0, 1, 2};
  const auto glb = deltamesh::write_mesh(mesh, deltamesh::FileFormat::kGlb);
  if (!glb || !deltamesh::read_mesh(*glb, deltamesh::FileFormat::kGlb)) return 1;
  const auto obj = deltamesh::write_mesh(mesh, deltamesh::FileFormat::kObj);
  if (!obj || !deltamesh::read_mesh(*obj, deltamesh::FileFormat::kObj)) return 2;
  return deltamesh::pack_gltf(*glb, {}) ? 0 : 3;
}
