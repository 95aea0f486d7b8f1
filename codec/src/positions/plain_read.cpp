// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include <bit>

#include "base/byte_reader.h"
#include "base/memory/large_vector.h"
#include "base/try.h"
#include "entropy/arrays.h"
#include "format/chunk/tags.h"
#include "format/vertex_positions.h"
#include "positions/plain.h"

namespace deltamesh {

Result<std::vector<float>> read_plain_positions(std::span<const std::byte> payload,
                                                std::uint32_t vertex_count,
                                                const PredictiveParameters& parameters) {
  ByteReader in(payload, kTagPositions);
  const bool are_floats = parameters.kind == PositionKind::kFloats;
  const PositionLattice& lattice = parameters.lattice;
  std::vector<float> rows;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    DELTAMESH_TRY(const auto numbers, read_differences(in, vertex_count, 32));
    reserve_large(rows, 3 * numbers.size());
    rows.resize(3 * numbers.size());
    for (std::size_t v = 0; v < numbers.size(); ++v) {
      if (!are_floats && numbers[v] > lattice.cells[axis])
        return in.invalid("a coordinate beyond the lattice", "PLN-5");
      rows[3 * v + axis] = are_floats ? std::bit_cast<float>(static_cast<std::uint32_t>(numbers[v]))
                                      : static_cast<float>(lattice.at(axis, static_cast<double>(numbers[v])));
    }
  }
  DELTAMESH_CHECK(in.finish());
  DELTAMESH_CHECK(check_finite(rows));
  return rows;
}

}  // namespace deltamesh
