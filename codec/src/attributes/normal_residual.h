// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Lattice points around a predicted normal, coded in the context of how sure the prediction is [ATTR-25].
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "attributes/normal_lattice.h"
#include "attributes/normal_prediction.h"
#include "entropy/split_number.h"

namespace deltamesh {

/// `Coder` is CompactWriter or CompactReader.
template <class Coder>
class NormalResidualCoder {
 public:
  static constexpr std::size_t kModels = 4;
  explicit NormalResidualCoder(Coder& coder) : coder_(coder), numbers_(coder) {
    for (std::size_t k = 0; k < kModels; ++k) models_[k].assign(kRows[k] + kPlaces[k] * kKinds, kFreshSplit);
  }

  struct Contexts {
    unsigned shift = 0;
    std::array<std::uint32_t, kModels> row{};
    std::array<std::uint32_t, kModels> place{};
    std::uint32_t scale_class = 0;
  };

  Contexts contexts_of(const NormalForecast& f) const noexcept {
    Contexts c;
    const double scale = f.count > 0 ? f.near * f.near : (f.bend < 4 ? f.bend : 4);
    c.shift = static_cast<unsigned>(std::clamp((exponent_of(scale) - 6) / 2, 0, 24));
    const auto of = [&](double square) {
      return static_cast<std::uint32_t>(
          std::clamp(exponent_of(square) + 7 - 2 * static_cast<int>(c.shift), 0, 15));
    };
    const std::uint32_t near = of(f.near * f.near);
    const std::uint32_t apart = of(f.apart);
    const std::uint32_t spread = of(f.spread);
    const std::uint32_t expect = of(f.expect);
    const std::uint32_t bend = of(f.bend);
    const std::uint32_t many = f.count > 0 ? (f.count < 3 ? 1 : 2) : 0;
    c.row = {near, apart * 16 + spread, near * 16 + expect, (bend * 4 + many) * 4 + near / 4};
    c.place = {near, apart / 2 * 8 + spread / 2, near / 2 * 8 + expect / 2, bend * 4 + near / 4};
    c.scale_class = of(scale);
    return c;
  }

  /// Codes `point`; a reader fills it in. False where it is out of range.
  bool code(const NormalForecast& f, LatticePoint& point) {
    const Contexts c = contexts_of(f);
    const std::int64_t row = code_number(point.row, 0, c, 0);
    if (row < -kMost || row > kMost) return false;
    const std::uint32_t size =
        std::min<std::uint32_t>(static_cast<std::uint32_t>(row < 0 ? -row : row) >> c.shift, 7);
    static constexpr std::array<std::uint8_t, 8> kSizes = {0, 1, 2, 2, 3, 3, 3, 3};
    const std::uint32_t odd = c.shift == 0 ? static_cast<std::uint32_t>(row & 1) : 0;
    const std::int64_t place = code_number(point.place, 1, c, kSizes[size] * 2 + odd);
    if (place < -kMost || place > kMost) return false;
    point = {static_cast<std::int32_t>(row), static_cast<std::int32_t>(place)};
    return true;
  }

 private:
  static constexpr std::uint32_t kAxes = 2;
  static constexpr std::uint32_t kKinds = 8;  ///< of places, by the row
  static constexpr std::array<std::uint32_t, kModels> kRows = {16, 256, 256, 256};
  static constexpr std::array<std::uint32_t, kModels> kPlaces = {16, 64, 64, 64};
  static constexpr std::int64_t kMost = std::int64_t{1} << 24;

  /// floor(log2 x) where x is in the range of normal numbers; -1023 below it, 1024 above.
  static int exponent_of(double x) noexcept {
    return x > 0 ? static_cast<int>(std::bit_cast<std::uint64_t>(x) >> 52) - 1023 : -1023;
  }

  std::int64_t code_number(std::int64_t value, std::uint32_t axis, const Contexts& c, std::uint32_t part) {
    const auto model = [&](std::size_t k) {
      return &models_[k][axis == 0 ? c.row[k] : kRows[k] + c.place[k] * kKinds + part];
    };
    const Mixture<kModels> mixture({model(0), model(1), model(2), model(3)},
                                   &mixes_[c.scale_class * 2 + axis]);
    return numbers_.code(coder_, value, c.shift, mixture);
  }

  Coder& coder_;
  std::array<std::vector<SymbolModel>, kModels> models_;
  std::array<MixWeights<kModels>, 32> mixes_;
  SplitNumberCoder<Coder> numbers_;
};

}  // namespace deltamesh
