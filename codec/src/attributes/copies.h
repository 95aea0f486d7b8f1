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

#include "base/zigzag.h"
#include "entropy/number_model.h"

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

/// Codes `rows`, one for every vertex; a reader fills them in. `geometric`: of every vertex, never falling,
/// each below `shared_count`; where it is empty, all rows are of the field. `code_first(vertex, rows)` codes
/// a row of the field, `code_copy(before, row)` one of a copy; they return false where the stream breaks a
/// rule, and so does this, or where, in a reader, the bytes end.
template <class Coder, class Row, class CodeFirst, class CodeCopy>
bool code_with_copies(Coder& coder, std::span<const std::uint32_t> geometric, std::size_t shared_count,
                      std::span<Row> rows, CodeFirst code_first, CodeCopy code_copy) {
  const auto goes_on = []([[maybe_unused]] const auto& source) {
    if constexpr (Coder::kWrites) {
      return true;
    } else {
      return !source.failed();
    }
  };
  if (geometric.empty()) {
    for (std::uint32_t v = 0; v < rows.size() && goes_on(coder); ++v)
      if (!code_first(v, rows)) return false;
    return goes_on(coder);
  }
  std::vector<Row> shared(shared_count, Row{});
  for (std::uint32_t v = 0; v < rows.size() && goes_on(coder); ++v) {
    const std::uint32_t g = geometric[v];
    if (v > 0 && geometric[v - 1] == g) {
      if (!code_copy(rows[v - 1], rows[v])) return false;
      continue;
    }
    if constexpr (Coder::kWrites) shared[g] = rows[v];
    if (!code_first(g, std::span<Row>(shared))) return false;
    rows[v] = shared[g];
  }
  return goes_on(coder);
}

}  // namespace deltamesh
