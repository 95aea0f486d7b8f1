// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Symbols of deltas, the three of a vertex together.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/memory/large_vector.h"
#include "base/simd/four_ints.h"

namespace deltamesh {

/// Four at once, the last one 0: in 16 bits each, as mostly all of a mesh fit in, or in 32.
using ShortSymbols = std::array<std::int16_t, 4>;
using LongSymbols = std::array<std::int32_t, 4>;

/// One row per vertex. Owns nothing.
class SymbolView {
 public:
  SymbolView() = default;
  explicit SymbolView(std::span<const ShortSymbols> rows) noexcept
      : short_(rows.data()), size_(rows.size()) {}
  explicit SymbolView(std::span<const LongSymbols> rows) noexcept : long_(rows.data()), size_(rows.size()) {}

  std::size_t size() const noexcept { return size_; }
  std::span<const ShortSymbols> short_rows() const noexcept { return {short_, is_short() ? size_ : 0}; }

  /// Some rows that follow each other.
  SymbolView part(std::size_t first, std::size_t count) const noexcept {
    return is_short() ? SymbolView(std::span(short_ + first, count))
                      : SymbolView(std::span(long_ + first, count));
  }

  FourInts operator[](std::size_t i) const noexcept {
    return is_short() ? widened(short_[i]) : std::bit_cast<FourInts>(long_[i]);
  }

 private:
  bool is_short() const noexcept { return short_ != nullptr; }
  static FourInts widened(const ShortSymbols& row) noexcept {
    const simde__m128i lanes = simde_mm_loadl_epi64(reinterpret_cast<const simde__m128i*>(row.data()));
    return reinterpret_cast<FourInts>(simde_mm_srai_epi32(simde_mm_unpacklo_epi16(lanes, lanes), 16));
  }

  const ShortSymbols* short_ = nullptr;
  const LongSymbols* long_ = nullptr;
  std::size_t size_ = 0;
};

class SymbolRows {
 public:
  SymbolRows() = default;
  /// `planar`: x of all vertices, then y, then z. O(n).
  explicit SymbolRows(std::span<const std::int32_t> planar);

  std::size_t size() const noexcept { return short_.size() + long_.size(); }
  SymbolView view() const noexcept { return short_.empty() ? SymbolView(long_) : SymbolView(short_); }

 private:
  LargeVector<ShortSymbols> short_;  ///< one of these is empty
  LargeVector<LongSymbols> long_;
};

}  // namespace deltamesh
