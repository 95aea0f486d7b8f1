// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Symbols of every kind one after the other, through a reader or a writer.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "entropy/coder/reader.h"
#include "entropy/coder/writer.h"

namespace deltamesh::fuzz {

inline constexpr std::size_t kMostRun = 4096;

/// As long as `goes_on(i)`. `values`: written, or, where they end, read and appended.
template <class Coder, class GoesOn>
void run_coder(Coder& coder, std::vector<std::uint32_t>& values, const GoesOn& goes_on) {
  constexpr SymbolModel kFresh({1, 1, 1, 1, 1, 1, 1, 9, 1, 1, 1, 1, 1, 1, 1, 1});
  std::array<SymbolModel, 2> models = {kFresh, kFresh};
  MixWeights weights;
  BitModel bit;
  NumberModel number;
  SymbolBits inner;
  for (std::size_t i = 0; goes_on(i); ++i) {
    if (i == values.size()) values.push_back(0);
    std::uint32_t& value = values[i];
    if (i % 5 == 0) value = coder.symbol(value, Mixture<2>{{&models[0], &models[1]}, &weights});
    if (i % 5 == 1) value = coder.bit(value != 0, bit) ? 1 : 0;
    if (i % 5 == 2) value = coder.bits(value, static_cast<unsigned>(i % 33));
    if (i % 5 == 3) value = coder.number(value, number);
    if (i % 5 == 4) {
      LowBits low{.count = static_cast<unsigned>(i % (kMostBitsAtOnce + 2)), .value = value >> 4};
      const Mixture<2> mixture{{&models[0], &models[1]}, &weights};
      const unsigned symbol = coder.symbol_and_bits(value % 16, low, mixture, inner);
      value = low.value << 4 | symbol;
    }
  }
}

}  // namespace deltamesh::fuzz
