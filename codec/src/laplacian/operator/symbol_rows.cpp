// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
#include "laplacian/operator/symbol_rows.h"

#include <limits>

namespace deltamesh {
namespace {

bool fits_short(std::span<const std::int32_t> symbols) noexcept {
  constexpr std::uint32_t kBias = std::uint32_t{1} << 15;
  std::uint32_t over = 0;  // what does not fit has one of the upper bits
  for (const std::int32_t q : symbols) over |= static_cast<std::uint32_t>(q) + kBias;
  return over <= std::numeric_limits<std::uint16_t>::max();
}

template <class T>
void fill_rows(std::span<const std::int32_t> planar, LargeVector<std::array<T, 4>>& rows) {
  const std::size_t n = planar.size() / 3;
  rows.resize(n);
  for (std::size_t i = 0; i < n; ++i)
    rows[i] = {static_cast<T>(planar[i]), static_cast<T>(planar[n + i]), static_cast<T>(planar[2 * n + i]),
               0};
}

}  // namespace

SymbolRows::SymbolRows(std::span<const std::int32_t> planar) {
  if (fits_short(planar)) {
    fill_rows(planar, short_);
  } else {
    fill_rows(planar, long_);
  }
}

}  // namespace deltamesh
