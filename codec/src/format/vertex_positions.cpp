// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "format/vertex_positions.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/memory/large_vector.h"
#include "base/try.h"

namespace deltamesh {

namespace {

Error not_finite(std::size_t vertex) noexcept {
  return {.code = ErrorCode::kInvalidStream,
          .message = "a decoded coordinate is not a finite float32",
          .rule = "GEO-1",
          .where_kind = WhereKind::kVertex,
          .where = vertex};
}

}  // namespace

Result<std::vector<Vec3>> to_float_positions(std::span<const Vec3> positions) {
  std::vector<Vec3> rounded(positions.begin(), positions.end());
  for (std::size_t i = 0; i < rounded.size(); ++i) {
    for (double& x : rounded[i]) {
      x = static_cast<float>(x);
      if (!std::isfinite(x)) return not_finite(i);
    }
  }
  return rounded;
}

Result<std::vector<float>> to_float_rows(std::span<const Vec3> positions) {
  std::vector<float> rows;
  reserve_large(rows, 3 * positions.size());
  rows.resize(3 * positions.size());
  auto row = rows.begin();
  for (const Vec3& position : positions)
    for (const double x : position) *row++ = static_cast<float>(x);
  DELTAMESH_CHECK(check_finite(rows));
  return rows;
}

Result<void> check_finite(std::span<const float> rows) {
  // One more in the exponent sets the sign where it has all ones; without a way out of the loop, for many at
  // once.
  constexpr std::uint32_t kExponent = 0xff << 23;
  constexpr std::uint32_t kOne = 1 << 23;
  std::uint32_t signs = 0;
  for (const float x : rows) signs |= (std::bit_cast<std::uint32_t>(x) & kExponent) + kOne;
  if (signs >> 31 == 0) return {};
  const auto first = std::find_if_not(rows.begin(), rows.end(), [](float x) { return std::isfinite(x); });
  return not_finite(static_cast<std::size_t>(first - rows.begin()) / 3);
}

std::vector<float> copy_rows(std::span<const float> rows, std::span<const std::uint32_t> copies) {
  std::vector<float> copied;
  reserve_large(copied, 3 * copies.size());
  for (const std::uint32_t from : copies) {
    const auto row = rows.subspan(3 * std::size_t{from}, 3);
    copied.insert(copied.end(), row.begin(), row.end());
  }
  return copied;
}

}  // namespace deltamesh
