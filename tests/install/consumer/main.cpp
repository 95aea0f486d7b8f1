// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// The README's example: this file is compiled and run against the installed package.
#include <cstdio>

#include "deltamesh/decode.h"
#include "deltamesh/encode.h"

int main() {
  deltamesh::Mesh mesh;
  mesh.positions = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
  mesh.triangles = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};
  const auto encoded = deltamesh::encode(mesh, {.bits = 8});
  if (!encoded) return std::puts(describe(encoded.error()).c_str()), 1;
  const auto decoded = deltamesh::decode(encoded->bytes);
  if (!decoded) return std::puts(describe(decoded.error()).c_str()), 1;
  std::printf("%zu bytes, largest error %g\n", encoded->bytes.size(), encoded->report.stream.quality.max_error);
  return decoded->triangle_count() == 4 ? 0 : 1;
}
