// SPDX-License-Identifier: Apache-2.0
// Copyright 2026 The deltamesh authors
//
// Adaptive models of the compact coder: symbols of 16 values, their mixtures, and bits [CMP-4 .. CMP-7].
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "entropy/lanes.h"

namespace deltamesh {

/// Probabilities are parts of 2^15 [CMP-2].
inline constexpr unsigned kProbabilityBits = 15;
inline constexpr std::uint32_t kProbabilityOne = 1U << kProbabilityBits;

/// A symbol's share of [0, 2^15).
struct Interval {
  std::uint32_t start;
  std::uint32_t size;  ///< at least 1
};

/// The share of `value` among `range` (1 to 2^15) values alike [CMP-10].
constexpr Interval part_of(std::uint32_t value, std::uint32_t range) noexcept {
  const std::uint32_t start = (value << kProbabilityBits) / range;
  return {start, ((value + 1) << kProbabilityBits) / range - start};
}

/// Full scale of a model's lanes: leaves room for the rounding term of the update below 2^15.
inline constexpr std::int16_t kLaneOne = 32512;

/// Distribution of one symbol in one context. Lane i holds the probability of a symbol below i.
struct alignas(16) SymbolModel {
  Lanes lanes{};
  std::int16_t all = kLaneOne;  ///< what would be the lane after the last
  std::uint16_t seen = 0;

  /// `weights`: 16 relative frequencies, sum above 0, below 2^16.
  explicit constexpr SymbolModel(const std::array<std::uint8_t, kSymbols>& weights) noexcept {
    std::uint32_t sum = 0;
    for (const std::uint8_t w : weights) sum += w;
    std::uint32_t below = 0;
    for (unsigned i = 0; i < kSymbols; ++i) {
      lanes[i] = static_cast<std::int16_t>(below * static_cast<std::uint32_t>(kLaneOne) / sum);
      below += weights[i];
    }
  }

  /// Probability of `symbol`, parts of kLaneOne.
  std::int32_t share(unsigned symbol) const noexcept {
    return (symbol + 1 == kSymbols ? all : lanes[symbol + 1]) - lanes[symbol];
  }

  /// Moves the lanes towards `symbol` by 2^-rate of the way, rounded away from where they are, at least
  /// to 1 / 128 of the way as more and more symbols were seen [CMP-5].
  void learn(unsigned symbol) noexcept {
    const unsigned rate = kRates[seen];
    seen = static_cast<std::uint16_t>(seen + (seen + 1U < kRates.size() ? 1 : 0));
    pull_lanes(lanes, kPulls[rate][symbol], rate);
  }

 private:
  static constexpr std::array<std::uint8_t, 125> kRates = [] {
    std::array<std::uint8_t, 125> rates{};
    for (unsigned n = 0; n < rates.size(); ++n)
      rates[n] = n < 4 ? 2 : n < 12 ? 3 : n < 28 ? 4 : n < 60 ? 5 : n < 124 ? 6 : 7;
    return rates;
  }();
  /// By rate: the goal is as far beyond kLaneOne as rounding needs.
  static constexpr std::array<Pulls, 8> kPulls = [] {
    std::array<Pulls, 8> pulls{};
    for (unsigned rate = 0; rate < pulls.size(); ++rate)
      pulls[rate] = make_pulls(static_cast<std::int16_t>(kLaneOne + (1 << rate) - 1));
    return pulls;
  }();
};

/// Weights of `K` models, learnt [CMP-6].
template <std::size_t K>
class MixWeights {
 public:
  constexpr MixWeights() noexcept {
    weights_.fill(static_cast<std::uint16_t>(kWeightOne / K));
    weights_.back() = static_cast<std::uint16_t>(kWeightOne - (K - 1) * (kWeightOne / K));
  }

  const std::array<std::uint16_t, K>& values() const noexcept { return weights_; }

  /// `shares`: probability that each model gave the symbol; `size`: what the mixture gave it.
  void learn(const std::array<std::int32_t, K>& shares, std::uint32_t size) noexcept {
    const auto inverse = static_cast<std::int64_t>((1U << 24) / size);
    std::uint32_t rest = kWeightOne;
    for (std::size_t k = 0; k + 1 < K; ++k) {
      const std::int64_t gain = (shares[k] - static_cast<std::int32_t>(size)) * inverse;  // of 2^24
      const std::int64_t moved = weights_[k] + ((weights_[k] * gain) >> (24 + kSlowness));
      const std::int64_t most = rest - kLeastWeight * (K - 1 - k);
      weights_[k] = static_cast<std::uint16_t>(std::clamp<std::int64_t>(moved, kLeastWeight, most));
      rest -= weights_[k];
    }
    weights_.back() = static_cast<std::uint16_t>(rest);
  }

 private:
  /// The sum of the weights: 2^15 stretched so that kLaneOne becomes 2^15 - 32, the 32 being given to
  /// all symbols alike.
  static constexpr std::uint32_t kWeightOne = 32994;
  static constexpr std::uint32_t kLeastWeight = 512;
  static constexpr unsigned kSlowness = 6;

  std::array<std::uint16_t, K> weights_{};
};

/// The interval of `symbol` under Mixture::starts().
inline Interval interval_of(const LaneSum& starts, unsigned symbol) noexcept {
  struct {
    Lanes lanes;
    std::uint16_t all = kProbabilityOne;
  } bounds;
  starts.store(bounds.lanes);
  const auto start = static_cast<std::uint32_t>(bounds.lanes[symbol]);
  const std::uint32_t end =
      symbol + 1 == kSymbols ? bounds.all : static_cast<std::uint32_t>(bounds.lanes[symbol + 1]);
  return {start, end - start};
}

/// `K` models of the same symbol in different contexts, and their weights.
template <std::size_t K>
struct Mixture {
  std::array<SymbolModel*, K> models;
  MixWeights<K>* weights;

  /// Lane i: parts of 2^15 of the symbols below i; each symbol has 2 at least [CMP-6].
  LaneSum starts() const noexcept {
    std::array<const Lanes*, K> lanes;
    for (std::size_t k = 0; k < K; ++k) lanes[k] = &models[k]->lanes;
    LaneSum sum(kFloor);
    sum.add_weighted(lanes, weights->values());
    return sum;
  }

  void learn(unsigned symbol, std::uint32_t size) noexcept {
    std::array<std::int32_t, K> shares;
    for (std::size_t k = 0; k < K; ++k) {
      if constexpr (K > 1) shares[k] = models[k]->share(symbol);
      models[k]->learn(symbol);
    }
    if constexpr (K > 1) weights->learn(shares, size);
  }

  static constexpr Lanes kFloor = {0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 26, 28, 30};
};

/// Probability of a set bit: the mean of a fast and a slow estimate [CMP-7].
class BitModel {
 public:
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
