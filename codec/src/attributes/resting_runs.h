// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// How many rows of a sparse field are at rest from one on around which all is [ATTR-59]. One template for
// both directions.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "entropy/number_model.h"
#include "predictive/blend.h"
#include "predictive/surroundings.h"

namespace deltamesh {

/// `Coder` is CompactWriter or CompactReader.
template <class Coder>
class RestingRuns {
 public:
  RestingRuns(Coder& coder, const KnownFaces& faces, const Cell& rest)
      : coder_(coder), faces_(faces), rest_(rest), moves_(faces.vertex_count(), 0) {}

  /// How many of `rows` rest from `row` on, the first copy of `vertex`, so that no more is coded of them; any
  /// number where a stream lies. A reader's rows are not looked at.
  std::uint32_t code(std::uint32_t row, std::uint32_t vertex, std::span<const Cell> rows) {
    if (row == end_ || moves_around(vertex)) return 0;
    std::uint32_t length = 0;
    if constexpr (Coder::kWrites)
      while (row + length < rows.size() && rows[row + length] == rest_) ++length;
    length = coder_.number(length, lengths_);
    end_ = row + length;
    return length;
  }

  /// Of a vertex that is in no run.
  void end(std::uint32_t vertex, const Cell& cell) noexcept { moves_[vertex] = cell != rest_ ? 1 : 0; }

 private:
  bool moves_around(std::uint32_t vertex) const noexcept {
    const NearCorners near = faces_.near(vertex);
    if (near.known_count == 0) return vertex > 0 && moves_[vertex - 1] != 0;
    const std::size_t last = near.known_count - 1;
    return (moves_[near.a[0]] | moves_[near.b[0]] | moves_[near.a[last]] | moves_[near.b[last]]) != 0;
  }

  Coder& coder_;
  const KnownFaces& faces_;
  Cell rest_;
  std::uint32_t end_ = kNoVertex;    ///< the row after the last run, which does not begin another
  std::vector<std::uint8_t> moves_;  ///< 1 or 0
  NumberModel lengths_;
};

}  // namespace deltamesh
