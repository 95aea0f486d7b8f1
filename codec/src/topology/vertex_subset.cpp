// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "topology/vertex_subset.h"

namespace deltamesh {

std::uint32_t VertexSubset::vertex(std::uint32_t row) const noexcept {
  const auto after = std::upper_bound(runs_.begin(), runs_.end(), row,
                                      [](std::uint32_t value, const Run& run) { return value < run.row; });
  return (after - 1)->begin + (row - (after - 1)->row);
}

std::optional<std::uint32_t> VertexSubset::row_of(std::uint32_t vertex) const noexcept {
  const auto run = std::upper_bound(runs_.begin(), runs_.end(), vertex,
                                    [](std::uint32_t value, const Run& r) { return value < r.end; });
  if (run == runs_.end() || vertex < run->begin) return std::nullopt;
  return run->row + (vertex - run->begin);
}

}  // namespace deltamesh
