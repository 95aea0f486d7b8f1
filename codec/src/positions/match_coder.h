// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Numbers that are exactly one of a few guesses, as on flat and swept surfaces [FLT-4]. One template for both
// directions.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "entropy/coder/symbol_models.h"
#include "positions/guesses.h"
#include "positions/surroundings.h"

namespace deltamesh {

struct MatchModels {
  static constexpr std::array<std::uint32_t, 2> kContexts = {3 * 4 * 7, 5 * 7 * 7};
  static constexpr SymbolModel kFresh{{8, 4, 2, 2, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1}};

  std::array<SymbolModels, 2> symbols{SymbolModels(kContexts[0], kFresh), SymbolModels(kContexts[1], kFresh)};
  MixWeights weights;

  void limit_counts(std::uint8_t most) noexcept {
    for (SymbolModels& models : symbols) models.limit_counts(most);
  }
};

template <class Coder>
class MatchCoder {
 public:
  explicit MatchCoder(Coder& coder, MatchModels start = {}) : coder_(coder), models_(std::move(start)) {}

  const MatchModels& models() const noexcept { return models_; }

  /// Whether `value`, which a reader gets, is one of `guesses`. Axes come in order; `missed`: a bit for every
  /// axis of the vertex that was none of its guesses, at first 0.
  bool code(std::size_t axis, const Surroundings& around, const Guesses& guesses, std::int32_t& value,
            unsigned& missed) {
    const unsigned before = missed;
    const unsigned count = guesses.count(axis);
    missed |= 1U << axis;
    if (count == 0) return false;
    const auto a = static_cast<unsigned>(axis);
    const unsigned sources = std::min(around.parallelogram_count, 4U);
    const unsigned history = a == 0 ? 0 : a == 1 ? 1 + (before & 1U) : 3 + (before & 3U);
    unsigned symbol = 0;
    if constexpr (Coder::kWrites) symbol = guesses.symbol_of(axis, value);
    symbol = coder_.symbol(
        symbol, Mixture<2>{{&models_.symbols[0][(a * 4 + (before & 3U)) * 7 + count],
                            &models_.symbols[1][(sources * 7 + history) * 7 + std::min(around.faces, 6U)]},
                           &models_.weights});
    if (symbol == 0 || symbol > count) return false;
    missed = before;
    value = guesses.at(axis, symbol - 1);
    return true;
  }

 private:
  Coder& coder_;
  MatchModels models_;
};

}  // namespace deltamesh
