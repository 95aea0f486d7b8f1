// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Grids, all of whose squares are cut along the same diagonal.
#pragma once

#include <cstdint>
#include <vector>

namespace deltamesh::test {

/// Over `columns` x `rows` vertices, row by row, the first of which has the number `first`.
inline std::vector<std::uint32_t> grid_triangles(std::uint32_t columns, std::uint32_t rows,
                                                 std::uint32_t first = 0) {
  std::vector<std::uint32_t> triangles;
  for (std::uint32_t y = 0; y + 1 < rows; ++y) {
    for (std::uint32_t x = 0; x + 1 < columns; ++x) {
      const std::uint32_t v = first + y * columns + x;
      triangles.insert(triangles.end(), {v, v + 1, v + columns, v + 1, v + columns + 1, v + columns});
    }
  }
  return triangles;
}

}  // namespace deltamesh::test
