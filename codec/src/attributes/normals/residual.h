// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Lattice points around a predicted normal, coded in the context of how sure the prediction is [ATTR-25].
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "attributes/normals/lattice.h"
#include "attributes/normals/prediction.h"
#include "entropy/coder/held_coder.h"
#include "entropy/coder/split_number.h"

namespace deltamesh {

/// `Coder` is CompactWriter or CompactReader.
template <class Coder>
class NormalResidualCoder {
 public:
  explicit NormalResidualCoder(Coder& coder) : coder_(coder), numbers_(coder) {}

  /// Codes `point`; a reader fills it in. False where it is out of range.
  bool code(const NormalPrediction& f, LatticePoint& point) {
    const auto shift = static_cast<unsigned>(std::clamp((exponent_of(f.scale) - 6) / 2, 0, 24));
    const auto of = [&](float square) {
      return static_cast<std::uint32_t>(
          std::clamp(exponent_of(square) + 7 - 2 * static_cast<int>(shift), 0, 15));
    };
    const std::uint32_t scale = of(f.scale);
    const std::uint32_t apart = of(f.apart);
    const std::uint32_t spread = of(f.spread);
    const std::uint32_t bend = of(f.bend);
    Held<Coder> coder = coder_;
    const std::int64_t row =
        code_number(coder, point.row, shift, scale, 0, scale * 16 + bend, apart * 16 + spread);
    const auto size = static_cast<std::uint32_t>(row < 0 ? -row : row) >> shift;
    const std::uint32_t odd = shift == 0 ? static_cast<std::uint32_t>(row & 1) : 0;
    const std::uint32_t kind = kSizes[std::min<std::uint32_t>(size, 7)] * 2 + odd;
    const std::int64_t place =
        code_number(coder, point.place, shift, scale, 1, kRows + (scale / 2 * 8 + bend / 2) * kKinds + kind,
                    kRows + (apart / 2 * 8 + spread / 2) * kKinds + kind);
    write_back<Coder>(coder, coder_);
    if (row < -kMost || row > kMost || place < -kMost || place > kMost) return false;
    point = {static_cast<std::int32_t>(row), static_cast<std::int32_t>(place)};
    return true;
  }

 private:
  static constexpr std::array<std::uint8_t, 8> kSizes = {0, 1, 2, 2, 3, 3, 3, 3};  ///< of rows, by the row
  static constexpr std::uint32_t kKinds = 8;                                       ///< of places, by the row
  static constexpr std::uint32_t kRows = 256;
  static constexpr std::uint32_t kPlaces = 64 * kKinds;
  static constexpr std::int64_t kMost = std::int64_t{1} << 24;

  /// floor(log2 x) where x is in the range of normal numbers; -127 below it, 128 above.
  static int exponent_of(float x) noexcept {
    return x > 0 ? static_cast<int>(std::bit_cast<std::uint32_t>(x) >> 23) - 127 : -127;
  }

  [[gnu::always_inline]] std::int64_t code_number(Coder& coder, std::int64_t value, unsigned shift,
                                                  std::uint32_t scale, std::uint32_t axis,
                                                  std::uint32_t first, std::uint32_t second) {
    const Mixture<2> mixture{{&by_scale_[first], &by_apart_[second]}, &mixes_[scale * 2 + axis]};
    return numbers_.code(coder, value, shift, mixture);
  }

  Coder& coder_;
  std::vector<SymbolModel> by_scale_ = std::vector(kRows + kPlaces, kFreshSplit);
  std::vector<SymbolModel> by_apart_ = std::vector(kRows + kPlaces, kFreshSplit);
  std::array<MixWeights, 32> mixes_;
  SplitNumberCoder<Coder> numbers_;
};

}  // namespace deltamesh
