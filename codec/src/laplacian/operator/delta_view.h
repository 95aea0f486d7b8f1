// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Delta coordinates as the solvers read them: doubles, or the whole numbers that a stream codes them as.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/numbers/vec3.h"
#include "base/simd/eight_shorts.h"
#include "base/simd/four_ints.h"
#include "base/simd/two_doubles.h"
#include "laplacian/operator/symbol_rows.h"

namespace deltamesh {

/// The value of a symbol q: 0 if q = 0, else step (|q| - shift) with the sign of q, where the shift is
/// shifts[1] for |q| = 1 and shifts[2] for larger |q| [DELT-2].
struct DeltaScale {
  double step = 1;                 ///< model units
  std::array<double, 3> shifts{};  ///< in steps, below 1; that of 0 is 0

  /// Without branches, which could not be predicted.
  double value(std::int32_t q) const noexcept {
    const double size = std::abs(static_cast<double>(q));
    const std::uint32_t bin =
        std::min(q < 0 ? 0 - static_cast<std::uint32_t>(q) : static_cast<std::uint32_t>(q), 2U);
    return step * std::copysign(size - shifts[bin], static_cast<double>(q));
  }
};

/// A view of deltas; does not own them.
class DeltaView {
 public:
  DeltaView() = default;
  DeltaView(std::span<const Vec3> values)  // NOLINT(google-explicit-constructor): doubles are the rule
      : values_(values), size_(values.size()) {}
  DeltaView(const std::vector<Vec3>& values)  // NOLINT(google-explicit-constructor)
      : values_(values), size_(values.size()) {}
  DeltaView(const SymbolView& symbols, const DeltaScale& scale)
      : symbols_(symbols), scale_(scale), size_(symbols.size()) {}

  std::size_t size() const noexcept { return size_; }

  Vec3 operator[](std::size_t i) const noexcept {
    if (!has_symbols()) return values_[i];
    const FourInts q = symbols_[i];
    return {scale_.value(q[0]), scale_.value(q[1]), scale_.value(q[2])};
  }

  bool has_symbols() const noexcept { return symbols_.size() > 0; }
  const DeltaScale& scale() const noexcept { return scale_; }
  const SymbolView& symbols() const noexcept { return symbols_; }

 private:
  std::span<const Vec3> values_;
  SymbolView symbols_;
  DeltaScale scale_;
  std::size_t size_ = 0;
};

/// Deltas as integers in units of step / 2^bits; the step of doubles is 1. Exact for symbols if `bits` is 8
/// or more. Values beyond 32 bits wrap, as do symbols of 2^23 or more.
class DeltaCounts {
 public:
  static constexpr int kMostBits = 30;

  /// `bits`: of symbols 0 to kMostBits, of doubles -126 to 126.
  DeltaCounts(const DeltaView& deltas, int bits) noexcept
      : deltas_(deltas),
        shift_of_ones_(parts_of(deltas.scale().shifts[1])),
        shift_of_others_(parts_of(deltas.scale().shifts[2])),
        left_(std::clamp(bits - 8, 0, 31)),
        right_(std::clamp(8 - bits, 0, 31)),
        half_(right_ > 0 ? std::uint32_t{1} << (right_ - 1) : 0),
        per_step_(std::ldexp(1.0, bits)),
        of_symbol_and_ones_(in_turns(256, signed_parts(shift_of_others_ - 2 * shift_of_ones_))),
        of_twos_(in_turns(signed_parts(shift_of_ones_ - shift_of_others_), 0)),
        short_(right_ == 0 ? deltas.symbols().short_rows().data() : nullptr) {}

  [[gnu::always_inline]] FourUnsigned operator[](std::size_t i) const noexcept {
    return short_ != nullptr ? of_short(short_[i]) : of_any(i);
  }

 private:
  /// Exact, with what the shifts take off made up of the symbol, cut to 1 and to 2 in size.
  [[gnu::always_inline]] FourUnsigned of_short(const ShortSymbols& row) const noexcept {
    using TwoLongs = std::int64_t __attribute__((vector_size(16)));
    const auto q = reinterpret_cast<EightShorts>(TwoLongs{std::bit_cast<std::int64_t>(row), 0});
    const EightShorts ones = smaller_lanes(larger_lanes(q, all_lanes(-1)), all_lanes(1));
    const EightShorts twos = smaller_lanes(larger_lanes(q, all_lanes(-2)), all_lanes(2));
    const FourInts parts = weighted_sums(q, ones, of_symbol_and_ones_) + weighted_sums(twos, twos, of_twos_);
    return reinterpret_cast<FourUnsigned>(parts) << left_;
  }

  [[gnu::noinline]] FourUnsigned of_any(std::size_t i) const noexcept {
    if (!deltas_.has_symbols()) {
      const Vec3 v = deltas_[i];
      return reinterpret_cast<FourUnsigned>(
          nearest_lanes(per_step_ * TwoDoubles{v[0], v[1]}, per_step_ * TwoDoubles{v[2], 0.0}));
    }
    const FourInts q = deltas_.symbols()[i];
    const auto sign = reinterpret_cast<FourUnsigned>(q >> 31);
    const FourUnsigned size = (reinterpret_cast<FourUnsigned>(q) ^ sign) - sign;
    const auto ones = reinterpret_cast<FourUnsigned>(size == 1);
    const auto others = reinterpret_cast<FourUnsigned>(reinterpret_cast<FourInts>(size) > 1);
    const FourUnsigned parts = (size << 8) - ((ones & shift_of_ones_) | (others & shift_of_others_));
    // One of the two shifts is by 0.
    const auto moved =
        reinterpret_cast<FourUnsigned>(reinterpret_cast<FourInts>((parts << left_) + half_) >> right_);
    return (moved ^ sign) - sign;
  }

  static std::uint32_t parts_of(double steps) noexcept {
    return static_cast<std::uint32_t>(static_cast<std::int32_t>(256 * steps));
  }

  static std::int32_t signed_parts(std::uint32_t parts) noexcept { return static_cast<std::int32_t>(parts); }

  DeltaView deltas_;
  std::uint32_t shift_of_ones_;  ///< 1/256 steps
  std::uint32_t shift_of_others_;
  int left_;
  int right_;
  std::uint32_t half_;
  double per_step_;
  EightShorts of_symbol_and_ones_;  ///< weights of a symbol and of it cut to 1 in size, in turns
  EightShorts of_twos_;             ///< weight of it cut to 2, and 0
  const ShortSymbols* short_;       ///< null where these are not all, or not exact
};

}  // namespace deltamesh
