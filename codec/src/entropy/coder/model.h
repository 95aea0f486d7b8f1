// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Adaptive models of the compact coder: symbols of 16 values, their mixtures, and bits [CMP-4 .. CMP-7].
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "base/small_code.h"
#include "entropy/coder/lanes.h"

namespace deltamesh {

/// Probabilities are parts of 2^15 [CMP-2].
inline constexpr unsigned kProbabilityBits = 15;
inline constexpr std::uint32_t kProbabilityOne = 1U << kProbabilityBits;

/// Between symbols the state is in [2^31, 2^63), as long as words are left [CMP-2].
inline constexpr std::uint64_t kRansFloor = std::uint64_t{1} << 31;

/// The state in which writers start and readers end, if possible. A higher state would carry information
/// [CMP-3].
inline constexpr std::uint64_t kLeastState = std::uint64_t{1} << 15;

/// More raw bits go in pieces [CMP-2].
inline constexpr unsigned kMostBitsAtOnce = 16;

/// A symbol's share of [0, 2^15).
struct Interval {
  std::uint32_t start;
  std::uint32_t size;  ///< at least 1
};

/// Bits that follow a symbol, at most kMostBitsAtOnce + 1 [CMP-12].
struct LowBits {
  unsigned count = 0;
  std::uint32_t value = 0;
};

/// Model of the highest of the bits that follow a symbol; it divides the symbol's interval [CMP-12].
class InnerBit {
 public:
  /// The part of the whole, of size 2 or more, that a set bit has; that is where the whole starts.
  std::uint32_t size_of_set(std::uint32_t whole) const noexcept {
    return 1 + (((whole - 2) * estimate_) >> 16);
  }
  /// `if_set`: all ones for a set bit, else 0.
  void learn(std::uint32_t if_set) noexcept {
    const auto way = static_cast<std::int32_t>((if_set & 0xffff) - estimate_);
    estimate_ = static_cast<std::uint16_t>(estimate_ + static_cast<std::uint32_t>(way >> kSlowness));
  }

 private:
  static constexpr unsigned kSlowness = 6;
  std::uint16_t estimate_ = 1U << 15;  ///< parts of 2^16
};
using SymbolBits = std::array<InnerBit, 16>;

/// The part of `whole` that the bit has.
constexpr Interval part_for_bit(Interval whole, std::uint32_t size_of_set, std::uint32_t if_set) noexcept {
  return {whole.start + (size_of_set & ~if_set), size_of_set + ((whole.size - 2 * size_of_set) & ~if_set)};
}

/// Full scale of a model's lanes: leaves room for the rounding term of the update below 2^15.
inline constexpr std::int16_t kLaneOne = 32512;

/// Distribution of one symbol in one context, an adaptive CDF: lane i holds the probability of a symbol below
/// i. With four symbols in place of 16, and a full scale of 32512, three times symbol 1 from an even start:
///
///   symbols seen   rate   lane 0   lane 1   lane 2   lane 3   (full)   share of symbol 1
///   0              2      0        8128     16256    24384    32512    1/4
///   1              2      0        6096     20320    26416    32512    7/16
///   2              3      0        4572     23368    27940    32512    37/64
///   3              3      0        4000     24511    28512    32512    0.63
///
/// Each lane above the symbol moves to the full scale, each other lane to 0, by 2^-rate of its way.
class alignas(16) SymbolModel {
 public:
  SymbolModel() = default;  ///< to be set before it is used
  /// `weights`: 16 relative frequencies, sum above 0, below 2^16.
  explicit constexpr SymbolModel(const std::array<std::uint8_t, kSymbols>& weights) noexcept
      : lanes_{}, count_(0) {
    std::uint32_t sum = 0;
    for (const std::uint8_t w : weights) sum += w;
    std::uint32_t below = 0;
    for (unsigned i = 0; i < kSymbols; ++i) {
      lanes_[i] = static_cast<std::int16_t>(below * static_cast<std::uint32_t>(kLaneOne) / sum);
      below += weights[i];
    }
    lanes_[kSymbols] = kLaneOne;
  }

  const std::int16_t* lanes() const noexcept { return lanes_.data(); }

  /// Probability of `symbol`, parts of kLaneOne.
  std::int32_t share(unsigned symbol) const noexcept { return lanes_[symbol + 1] - lanes_[symbol]; }

  /// Moves the lanes towards `symbol` by 2^-rate of the way, rounded away from where they are, at least
  /// to 1 / 128 of the way as more and more symbols were seen [CMP-5].
  [[gnu::always_inline]] void learn(unsigned symbol) noexcept {
    const auto [rate, next] = kSteps[count_];
    count_ = next;
    adapt_lanes(lanes_.data(), kTargets[rate][symbol], rate);
  }

  /// Limits the count of symbols seen, so that a model learnt from another mesh adapts faster [CMP-16].
  void limit_count(std::uint8_t most) noexcept { count_ = std::min(count_, most); }

 private:
  static constexpr unsigned kLastRate = 7;
  static constexpr unsigned kMostCounted = 122;
  struct Step {
    std::uint8_t rate;
    std::uint8_t next;  ///< how many symbols will have been seen
  };
  /// By number of symbols seen: rate 2 for the first 2, 3 for the next 8, 4 for the next 16, and twice as
  /// many for each further rate.
  static constexpr std::array<Step, kMostCounted + 1> kSteps = [] {
    std::array<Step, kMostCounted + 1> steps{};
    std::uint8_t rate = 2;
    for (unsigned count = 0; count <= kMostCounted; ++count) {
      if (count + 6 == 2U << rate) ++rate;
      steps[count] = {rate, static_cast<std::uint8_t>(std::min(count + 1, kMostCounted))};
    }
    return steps;
  }();
  /// By rate. The goal exceeds kLaneOne by the amount that rounding takes off.
  DELTAMESH_TABULATE static std::array<CdfTargets, kLastRate + 1> make_targets_by_rate() noexcept {
    std::array<CdfTargets, kLastRate + 1> targets{};
    for (unsigned rate = 0; rate < targets.size(); ++rate)
      targets[rate] = make_targets(static_cast<std::int16_t>(kLaneOne + (1 << rate) - 1));
    return targets;
  }
  static const std::array<CdfTargets, kLastRate + 1> kTargets;

  std::array<std::int16_t, kSymbols + 1> lanes_;  ///< the last is after all symbols and stays
  std::uint8_t count_;                            ///< symbols seen, to kMostCounted
};
inline const std::array<CdfTargets, SymbolModel::kLastRate + 1> SymbolModel::kTargets =
    make_targets_by_rate();

/// Weights of two models, learnt [CMP-6].
class MixWeights {
 public:
  /// Each at least 512, below 2^15.
  const std::array<std::uint16_t, 2>& values() const noexcept { return weights_; }

  /// Moves the first weight by 1 / 32 of the way to its model's share in what the mixture gave the symbol,
  /// but for a part that each always has. `share`: probability that the first model gave the symbol; `size`:
  /// what the mixture gave it.
  [[gnu::always_inline]] void learn(std::int32_t share, std::uint32_t size) noexcept {
    const std::uint64_t inverse = kLearnt / size;
    const std::uint32_t before = weights_[0];
    const auto goal =
        static_cast<std::int32_t>((before * static_cast<std::uint32_t>(share) * inverse) >> kLearntBits);
    const std::int32_t way =
        goal + static_cast<std::int32_t>(kLeastWeight) - static_cast<std::int32_t>(before);
    const std::uint32_t first = before + static_cast<std::uint32_t>(way >> kSlowness);
    // Stored at once, as both are soon read.
    weights_ = std::bit_cast<std::array<std::uint16_t, 2>>(first | (kWeightOne - first) << 16);
  }

 private:
  /// The sum of the weights: 2^15 stretched so that kLaneOne becomes 2^15 - 32, the 32 being given to
  /// all symbols alike.
  static constexpr std::uint32_t kWeightOne = 32994;
  static constexpr std::uint32_t kLeastWeight = 512;
  static constexpr unsigned kSlowness = 5;
  static constexpr unsigned kLearntBits = 24;
  /// 2^24, less what a model always has.
  static constexpr std::uint32_t kLearnt =
      (std::uint64_t{kWeightOne - 2 * kLeastWeight} << kLearntBits) / kWeightOne;

  std::array<std::uint16_t, 2> weights_{kWeightOne / 2, kWeightOne / 2};
};

/// The interval of `symbol` under Mixture::starts().
inline Interval interval_of(const LaneSum& starts, unsigned symbol) noexcept {
  alignas(16) std::array<std::uint16_t, kSymbols + 1> bounds;
  starts.store(bounds.data());
  bounds[kSymbols] = kProbabilityOne;
  return {bounds[symbol], std::uint32_t{bounds[symbol + 1]} - bounds[symbol]};
}

/// One model of a symbol, or two in different contexts with their weights.
template <std::size_t K>
struct Mixture {
  static_assert(K == 1 || K == 2);

  /// Lane i: parts of 2^15 of the symbols below i; each symbol has 2 at least [CMP-6].
  [[gnu::always_inline]] LaneSum starts() const noexcept {
    const MixWeights halves;
    return {models[0]->lanes(), models[K - 1]->lanes(), K == 1 ? halves.values() : weights->values()};
  }

  [[gnu::always_inline]] void learn(unsigned symbol, std::uint32_t size) const noexcept {
    if constexpr (K == 2) weights->learn(models[0]->share(symbol), size);
    models[0]->learn(symbol);
    if constexpr (K == 2) models[1]->learn(symbol);
  }

  std::array<SymbolModel*, K> models;
  MixWeights* weights = nullptr;  ///< null with one model
};

/// Probability of a set bit: the mean of a fast and a slow estimate [CMP-7].
class BitModel {
 public:
  constexpr BitModel() noexcept = default;
  explicit constexpr BitModel(std::uint16_t first) noexcept : fast_(first), slow_(first) {}  ///< of 2^16
  Interval interval(bool bit) const noexcept {
    const std::uint32_t one = probability();
    const std::uint32_t if_clear = bit ? 0 : ~0U;  // selects without a branch, which would often go wrong
    return {one & if_clear, (one ^ if_clear) + (if_clear & (kProbabilityOne + 1))};
  }
  std::uint32_t probability() const noexcept {
    return std::clamp<std::uint32_t>((std::uint32_t{fast_} + slow_) >> 2, 32, kProbabilityOne - 32);
  }
  void learn(bool bit) noexcept {
    const std::uint32_t goal = bit ? 65535 : 0;
    fast_ = static_cast<std::uint16_t>(fast_ + (static_cast<std::int32_t>(goal - fast_) >> 4));
    slow_ = static_cast<std::uint16_t>(slow_ + (static_cast<std::int32_t>(goal - slow_) >> 7));
  }

 private:
  std::uint16_t fast_ = 32768;
  std::uint16_t slow_ = 32768;
};

}  // namespace deltamesh
