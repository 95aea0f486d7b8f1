// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Shared by the readers of all kinds of positions: reads rows in the coding order and puts them into decoded
// order.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/broken_rule.h"
#include "base/memory/large_vector.h"
#include "base/try.h"
#include "entropy/coder/reader.h"
#include "format/chunk/tags.h"
#include "format/predictive_parameters.h"
#include "positions/coding_order.h"

namespace deltamesh {

inline Error broken_positions(const char* message, const char* rule) noexcept {
  return broken_rule(message, rule, kTagPositions);
}

/// n x 3, from `at(v, axis)`. Room is made ready bit by bit, so that it is in the cache when it is filled.
template <class At>
std::vector<float> to_rows(std::size_t count, const At& at) {
  constexpr std::size_t kAtOnce = 1024;
  std::vector<float> rows;
  reserve_large(rows, 3 * count);
  for (std::size_t v = 0; v < count;) {
    const std::size_t end = std::min(count, v + kAtOnce);
    rows.resize(3 * end);
    for (float* row = rows.data() + 3 * v; v < end; ++v, row += 3)
      for (std::size_t axis = 0; axis < 3; ++axis) row[axis] = at(v, axis);
  }
  return rows;
}

inline std::vector<float> to_rows(std::span<const Cell> cells, const PositionLattice& lattice) {
  return to_rows(cells.size(), [&](std::size_t v, std::size_t axis) {
    return static_cast<float>(lattice.at(axis, cells[v][axis]));
  });
}

/// n x 3, by vertex. `read(reader, coding_order, order)` reads what follows the coding order and makes
/// `order` as known_in_order() does: n x 3, by place in it. Errors: those of `read`, kInvalidStream
/// [POSN-10].
template <class Read>
Result<std::vector<float>> read_in_order(std::span<const std::byte> bytes, const Read& read) {
  CompactReader reader(bytes);
  CodingOrder coding_order{};
  if (!code_coding_order(reader, coding_order))
    return broken_positions("an order of vertices that is not known", "POSN-10");
  std::vector<std::uint32_t> order;
  DELTAMESH_TRY(auto ordered, read(reader, coding_order, order));
  if (order.empty()) return ordered;
  std::vector<float> rows(ordered.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t axis = 0; axis < 3; ++axis)
      rows[3 * std::size_t{order[i]} + axis] = ordered[3 * i + axis];
  return rows;
}

}  // namespace deltamesh
