// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Any payloads of a grid. The last nine bytes say how many vertices, triangles and bytes of other faces there
// are, how many levels an edge has, and how many nodes the grid. What is read is written again, and must come
// back.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

#include "goal.h"
#include "grid/grid.h"

namespace {

using namespace deltamesh;

fuzz::Goal grid_alone("a grid");
fuzz::Goal grid_with_rest("a grid with other faces");

constexpr std::size_t kTail = 9;

std::uint32_t two_bytes(const std::uint8_t* at) noexcept { return at[0] | std::uint32_t{at[1]} << 8; }

/// On a lattice whose points are their own places.
std::vector<Cell> cells_at(std::span<const float> positions) {
  std::vector<Cell> cells(positions.size() / 3);
  for (std::size_t i = 0; i < positions.size(); ++i)
    cells[i / 3][i % 3] = static_cast<std::int32_t>(positions[i]);
  return cells;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < kTail) return 0;
  const std::uint8_t* const tail = data + size - kTail;
  const std::uint32_t vertices = two_bytes(tail);
  const std::uint32_t triangles = two_bytes(tail + 2);
  const auto bytes = std::as_bytes(std::span(data, size - kTail));
  const std::size_t rest = std::min<std::size_t>(two_bytes(tail + 4), bytes.size());
  const GridChunks chunks{bytes.first(bytes.size() - rest), bytes.last(rest)};
  PredictiveParameters parameters{.kind = PositionKind::kVoxel, .lattice = {}, .levels = tail[6] + 1U};
  for (std::size_t axis = 0; axis < 3; ++axis)
    parameters.lattice.cells[axis] = 2 * parameters.levels * (axis == 0 ? tail[7] : tail[8]);
  const auto read = read_grid(chunks, parameters, vertices, triangles);
  if (!fuzz::check(read)) return 0;
  if (read->triangles.size() != 3 * std::size_t{triangles} ||
      read->positions.size() != 3 * std::size_t{vertices})
    std::abort();
  for (const std::uint32_t v : read->triangles)
    if (v >= vertices) std::abort();
  for (const float x : read->positions)
    if (!std::isfinite(x)) std::abort();
  const auto written = write_grid(read->triangles, cells_at(read->positions), parameters);
  if (!written) return 0;
  const auto again = read_grid(chunks_of(written->payloads), parameters, vertices, triangles);
  if (!again || again->triangles != written->triangles) std::abort();
  for (std::size_t v = 0; v < vertices; ++v)
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (again->positions[3 * v + axis] != read->positions[3 * std::size_t{written->vertex_order[v]} + axis])
        std::abort();
  (rest == 0 ? grid_alone : grid_with_rest).reach();
  return 0;
}
