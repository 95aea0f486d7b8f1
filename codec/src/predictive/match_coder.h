// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Numbers that are exactly one of a few guesses, as on flat and swept surfaces [FLT-4]. One template for both
// directions.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <vector>

#include "entropy/compact_model.h"
#include "predictive/blend.h"
#include "predictive/surroundings.h"

namespace deltamesh {

/// Different numbers, nearest to the expected one first.
class Guesses {
 public:
  static constexpr unsigned kMost = 6;

  explicit Guesses(std::int64_t expected) noexcept : expected_(expected) {}

  /// Keeps the order of adding among equally near ones; the seventh and later are dropped.
  void add(std::int32_t value) noexcept {
    const auto end = values_.begin() + count_;
    if (count_ == kMost || std::find(values_.begin(), end, value) != end) return;
    unsigned place = count_++;
    for (; place > 0 && off(values_[place - 1]) > off(value); --place) values_[place] = values_[place - 1];
    values_[place] = value;
  }

  unsigned count() const noexcept { return count_; }
  std::int32_t operator[](unsigned i) const noexcept { return values_[i]; }
  /// One more than the place of `value`, or 0.
  unsigned symbol_of(std::int32_t value) const noexcept {
    for (unsigned i = 0; i < count_; ++i)
      if (values_[i] == value) return i + 1;
    return 0;
  }

 private:
  std::int64_t off(std::int32_t value) const noexcept { return std::llabs(value - expected_); }

  std::int64_t expected_;
  std::array<std::int32_t, kMost> values_{};
  unsigned count_ = 0;
};

/// The corners of the parallelograms, as far as they are 0 to `largest`, then those of the known faces
/// [POSN-9].
inline Guesses guesses_around(const Surroundings& around, std::span<const Cell> cells, std::size_t axis,
                              std::int64_t expected, std::uint32_t largest) noexcept {
  Guesses guesses(expected);
  for (unsigned i = 0; i < around.known_count; ++i) {
    const auto& [a, b, opposite] = around.known[i];
    if (opposite == kNoVertex) continue;
    const std::int64_t corner = std::int64_t{cells[a][axis]} + cells[b][axis] - cells[opposite][axis];
    if (corner >= 0 && corner <= largest) guesses.add(static_cast<std::int32_t>(corner));
  }
  for (unsigned i = 0; i < around.known_count; ++i) {
    guesses.add(cells[around.known[i].a][axis]);
    guesses.add(cells[around.known[i].b][axis]);
  }
  return guesses;
}

template <class Coder>
class MatchCoder {
 public:
  explicit MatchCoder(Coder& coder) : coder_(coder) {
    for (std::size_t i = 0; i < models_.size(); ++i) models_[i].assign(kContexts[i], kFresh);
  }

  /// Whether `value`, which a reader gets, is one of `guesses`. Axes come in order; `missed`: a bit for every
  /// axis of the vertex that was none of its guesses, at first 0.
  bool code(std::size_t axis, const Surroundings& around, const Guesses& guesses, std::int32_t& value,
            unsigned& missed) {
    const unsigned before = missed;
    missed |= 1U << axis;
    if (guesses.count() == 0) return false;
    const auto a = static_cast<unsigned>(axis);
    const unsigned sources = std::min(around.parallelogram_count, 4U);
    const unsigned history = a == 0 ? 0 : a == 1 ? 1 + (before & 1U) : 3 + (before & 3U);
    const unsigned symbol =
        coder_.symbol(guesses.symbol_of(value),
                      Mixture<2>{{&models_[0][(a * 4 + (before & 3U)) * 7 + guesses.count()],
                                  &models_[1][(sources * 7 + history) * 7 + std::min(around.faces, 6U)]},
                                 &weights_});
    if (symbol == 0 || symbol > guesses.count()) return false;
    missed = before;
    value = guesses[symbol - 1];
    return true;
  }

 private:
  static constexpr std::array<std::uint32_t, 2> kContexts = {3 * 4 * 7, 5 * 7 * 7};
  static constexpr SymbolModel kFresh{{8, 4, 2, 2, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1}};

  Coder& coder_;
  std::array<std::vector<SymbolModel>, 2> models_;
  MixWeights<2> weights_;
};

}  // namespace deltamesh
