// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Rows of numbers at the copies of geometric vertices: the first copy's by a field, the others' from the copy
// before [ATTR-58]. One template for both directions.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/numbers/zigzag.h"
#include "entropy/coder/number_model.h"

namespace deltamesh {

/// The numbers of a copy from those of the copy before it; `N` of a row.
template <class Coder, std::size_t N>
class CopyCoder {
 public:
  using Row = std::array<std::int32_t, N>;

  /// Numbers from `axes` on are not coded.
  CopyCoder(Coder& coder, std::size_t axes) : coder_(coder), axes_(axes) {}

  /// Numbers of an invalid stream may have any value.
  void code(const Row& before, Row& row) {
    was_same_ = coder_.bit(row == before, same_[was_same_ ? 1 : 0]);
    if (was_same_) {
      row = before;
      return;
    }
    for (std::size_t axis = 0; axis < axes_; ++axis) {
      const auto from = static_cast<std::uint32_t>(before[axis]);
      const auto step = static_cast<std::int32_t>(static_cast<std::uint32_t>(row[axis]) - from);
      const auto coded = static_cast<std::uint32_t>(unzigzag(coder_.number(zigzag(step), numbers_[axis])));
      row[axis] = static_cast<std::int32_t>(from + coded);
    }
  }

 private:
  Coder& coder_;
  std::size_t axes_;
  bool was_same_ = true;
  std::array<BitModel, 2> same_;
  std::array<NumberModel, N> numbers_;
};

/// For fields in which every row is coded.
inline constexpr auto kNoneAtRest = [](std::uint32_t, std::uint32_t) { return std::uint32_t{0}; };

/// Codes `rows`, one for every vertex; a reader fills them in. `geometric`: of every vertex, never falling,
/// each below `shared_count`; where it is empty, all rows are of the field. `code_first(vertex, rows)` codes
/// a row of the field, `code_copy(before, row)` one of a copy; they return false where the stream breaks a
/// rule, and so does this, or where, in a reader, the bytes end. `count_at_rest(v, vertex)`, asked before the
/// first row of each vertex: how many rows from v on are `rest`, as a reader's are at first, so that nothing
/// is coded of them.
template <class Coder, class Row, class CodeFirst, class CodeCopy, class CountAtRest = decltype(kNoneAtRest)>
bool code_with_copies(Coder& coder, std::span<const std::uint32_t> geometric, std::size_t shared_count,
                      std::span<Row> rows, CodeFirst code_first, CodeCopy code_copy, const Row& rest = {},
                      CountAtRest count_at_rest = kNoneAtRest) {
  const bool has_copies = !geometric.empty();
  std::vector<Row> shared(has_copies ? shared_count : 0, rest);
  const std::span<Row> field = has_copies ? std::span<Row>(shared) : rows;
  for (std::uint32_t v = 0; v < rows.size() && !coder.failed(); ++v) {
    const std::uint32_t vertex = has_copies ? geometric[v] : v;
    if (has_copies && v > 0 && geometric[v - 1] == vertex) {
      if (!code_copy(rows[v - 1], rows[v])) return false;
      continue;
    }
    const std::uint32_t resting = count_at_rest(v, vertex);
    if (resting > rows.size() - v) return false;
    if (resting > 0) {
      v += resting - 1;
      continue;
    }
    if constexpr (Coder::kWrites) field[vertex] = rows[v];
    if (!code_first(vertex, field)) return false;
    rows[v] = field[vertex];
  }
  return !coder.failed();
}

}  // namespace deltamesh
