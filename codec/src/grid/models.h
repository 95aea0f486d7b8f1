// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// All that the grid coder learns.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "entropy/coder/counted_bit.h"
#include "entropy/coder/model.h"
#include "entropy/coder/number_model.h"
#include "entropy/coder/symbol_models.h"
#include "grid/cube/cube.h"
#include "grid/cube/pattern.h"

namespace deltamesh::grid {

/// A model of symbols below `count`, all alike.
constexpr SymbolModel even_model(unsigned count) noexcept {
  std::array<std::uint8_t, kSymbols> weights{};
  for (unsigned i = 0; i < count; ++i) weights[i] = 1;
  return SymbolModel(weights);
}

/// Patterns that cubes with the same signs had, the usual ones first [GRD-5].
struct KnownPatterns {
  static constexpr unsigned kMost = 15;

  CountedBit is_other{1500};  ///< than the first one
  std::uint8_t count = 0;
  std::array<std::uint16_t, kMost> numbers;  ///< of `count` patterns
};

/// Models of new patterns [GRD-6].
struct PatternModels {
  CountedBit is_any{6000};
  CountedBit around_outside;
  std::array<SymbolModel, kEdges + 1> apex = [] {  // by corners of the polygon
    std::array<SymbolModel, kEdges + 1> models{};
    for (unsigned corners = 4; corners <= kEdges; ++corners) models[corners] = even_model(corners - 2);
    return models;
  }();
  SymbolModel count = even_model(kSymbols);
  std::array<SymbolModel, 3> corner = {even_model(kEdges + 1), even_model(kEdges + 1),
                                       even_model(kEdges + 1)};

  void limit_counts(std::uint8_t most) noexcept {
    is_any.limit_count(most);
    around_outside.limit_count(most);
    for (SymbolModel& model : apex) model.limit_count(most);
    count.limit_count(most);
    for (SymbolModel& model : corner) model.limit_count(most);
  }
};

/// Where surfaces begin [GRD-7].
struct SeedModels {
  CountedBit is_seed;
  NumberModel brick;
  NumberModel cube;
};

/// Some 100 kB.
struct GrowthModels {
  static constexpr std::size_t kFlags = 256 * 64;
  static constexpr std::size_t kSigns = 3 * 2187;
  static constexpr SymbolModel kFreshRank{{0, 4, 2, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 4}};
  /// By how many cubes across faces have none, 3 at most [GRD-3].
  static constexpr std::array<std::uint16_t, 4> kFreshFlags = {3 << 14, 3 << 13, 1 << 13, 1 << 12};
  static constexpr std::array<std::uint16_t, 3> kFreshSigns = {20000, 32768, 45536};  ///< by majority [GRD-4]

  GrowthModels() {
    for (std::size_t i = 0; i < kFlags; ++i)
      flags[i] = CountedBit(kFreshFlags[std::min<std::size_t>(i >> 3 & 7, 3)]);
    for (std::size_t i = 0; i < kSigns; ++i) signs[i] = CountedBit(kFreshSigns[i % 3]);
  }

  std::array<CountedBit, kFlags> flags;
  std::array<CountedBit, kSigns> signs;
  std::array<KnownPatterns, 256> known;  ///< by signs
  std::vector<ListedPattern> patterns;
  SymbolModel rank = kFreshRank;
  PatternModels pattern;
  SeedModels seeds;

  /// All but those of seeds.
  void limit_counts(std::uint8_t most) noexcept {
    for (CountedBit& bit : flags) bit.limit_count(most);
    for (CountedBit& bit : signs) bit.limit_count(most);
    for (KnownPatterns& list : known) list.is_other.limit_count(most);
    rank.limit_count(most);
    pattern.limit_counts(most);
  }
  void forget_seeds() { seeds = SeedModels{}; }

  /// `fresh`, as the last one that is known for cubes with these signs.
  const ListedPattern& add(Signs of_cubes, const Pattern& fresh) {
    KnownPatterns& list = known[of_cubes];
    if (list.count < KnownPatterns::kMost) {
      list.numbers[list.count++] = static_cast<std::uint16_t>(patterns.size());
      return patterns.emplace_back(fresh);
    }
    return patterns[list.numbers[list.count - 1]] = ListedPattern(fresh);
  }
};

}  // namespace deltamesh::grid
